// A file of this name is enough: the call is refused before physgen runs.
