"""The Qt front end of hapticplayer."""

import os

# PySide6 makes a class when it is first named. Two threads that name one at once, such as
# the window's and the one that imports the plots, crash in the class without its
# metaobject. All are made at the start instead, in 0.1 s.
os.environ["PYSIDE6_OPTION_LAZY"] = "0"
