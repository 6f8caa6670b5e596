# awk -v folder=DIR -f blocks.awk PAGE: writes the example of a page of documentation below DIR: each block of code after a
# paragraph whose last line names a file in backticks; blocks of one file follow each other in it.
!open && match($0, /`[A-Za-z_]+\.[a-z]+`/) { name = substr($0, RSTART + 1, RLENGTH - 2); next }
/^```/ { open = !open && name != ""; if (!open) name = ""; next }
open { print >(folder "/" name) }
!NF { if (!open) name = "" }
