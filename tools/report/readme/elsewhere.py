"""What looks measured in READMEs and comes from no file of results."""
# Parts of READMEs, from one text to another ("" is the end), in which all that looks measured must be held by results
# or stand in ELSEWHERE: words as in SENTENCES, and where they are from.
COMPLETE = {"README.md": ("## Measured", "What accessors cost:"), "tools/physbench/README.md": ("# physbench", "")}
ELSEWHERE = {
    "README.md": [
        ("The paper's table 1 (GTX 285, 2010) had {}, {} and {} for the first three.", "the paper"),
        (
            "runs at the rate of a copy ({} to {}), {} to {} times as fast as the better of the two ways over AoS",
            "`tools/dev run --threads=1` on such a machine; no results of it are checked in",
        ),
        ("One CPU core with AVX-512 (AMD EPYC, {} objects,", "as above"),
        ("the stress derivative at {} to {} of a copy, {} to {} times AoS.", "as above"),
        ("The SVD does {} million matrices a second ({} million in packs of 8,", "as above"),
        ("Eigen's JacobiSVD {} million.", "as above"),
    ],
    "tools/physbench/README.md": [
        ("compressed by {} % with a bulge", "fem/mesh/truth_cube.cpp"),
        ("Default sizes ({} tets on the CPU, {} on the GPU)", "options.h"),
        ("the same row took {} ms; that way is gone", "a way to copy that is gone; no command measures it any more"),
        ("| `random` | I + {} N(0,1) |", "how the set is made"),
    ],
}
