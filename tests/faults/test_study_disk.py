"""Full and read-only disks: no answer is lost unnoticed."""


def test_a_full_disk_stops_the_participant_and_no_answer_is_lost(on_its_own_disk):
    reported = on_its_own_disk("study_disk.py", "full")
    assert reported["kind"] == "problem"
    assert "could not be saved (the disk at /" in reported["problem"]
    assert reported["interrupts"] > 0
    assert 1 <= reported["accepted"] < 12
    assert reported["kept"] == reported["accepted"]
    assert reported["after"] != "problem"
    assert reported["kept_in_the_end"] == 12


def test_a_read_only_disk_is_reported_before_the_first_answer(on_its_own_disk):
    reported = on_its_own_disk("study_disk.py", "read-only")
    for action in ("begin", "resume"):
        assert "Read-only file system" in reported[action]
        assert "\n" not in reported[action]
    assert (reported["kept"], reported["sessions"]) == (1, 1)
