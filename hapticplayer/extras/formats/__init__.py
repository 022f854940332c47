"""Force for other programs: MPEG haptics and MPEG-V, AHAP, WAV, funscript."""
