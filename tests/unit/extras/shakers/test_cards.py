"""Whether a sound card is there, and its channels one by one."""

from hapticplayer.devices import find_device
from hapticplayer.devices.guides import guide_of
from hapticplayer.extras.shakers import cards
from hapticplayer.extras.shakers.settings import shaker_settings


def test_a_sound_card_is_looked_for_in_a_process_of_its_own(monkeypatch):
    monkeypatch.setattr(cards, "ANSWER_S", 120.0)  # however busy the machine is
    check = cards.check_card(shaker_settings("there is no such card,channels=3+4"))
    assert check.what == "Sound output 'there is no such card' with the channels 3+4"
    assert check.is_met is False
    assert "cannot be opened with 4 channels" in check.remedy
    monkeypatch.setattr(cards, "ANSWER_S", 0.0)
    assert "restart it" in cards.check_card(shaker_settings("")).remedy


def test_a_card_that_opens_is_found(monkeypatch, capsys):
    monkeypatch.setattr(cards, "CardStream", lambda *_: None)
    assert cards.main("pulse") == 0
    assert capsys.readouterr().out == '""'


def test_a_shaker_is_tested_channel_by_channel():
    parts = guide_of(find_device("shaker")).parts(shaker_settings("pulse,channels=3+4"))
    assert [label for label, _ in parts] == ["3", "4"]
    assert find_device(parts[1][1]).chosen.startswith("pulse,channels=4,")
