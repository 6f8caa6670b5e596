"""Random values, of a seed that is printed."""
import random

import numpy as np

SEED = random.randrange(2**32)
print("seed", SEED)


def values(shape, seed=0, dtype=np.float32):
    return np.random.default_rng(SEED + seed).uniform(-1, 1, shape).astype(dtype)
