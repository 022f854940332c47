"""What a person records here: IMUs and phones as they measure, and their clocks."""
