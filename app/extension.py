"""The rows that windows of extras and of other packages add to the window."""

from hapticplayer.extension import Extensions

rows = Extensions("app.extras", "hapticplayer.windows").rows
