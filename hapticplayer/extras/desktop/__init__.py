"""The program among the others of a desktop: entry, kinds of files, icon, man page."""
