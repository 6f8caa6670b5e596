"""picture.py FOLDER PICTURE.png: draws what `particles FOLDER` saved, from the side, coloured by speed."""
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

x, v = np.load(sys.argv[1] + "/x.npy"), np.load(sys.argv[1] + "/v.npy")
figure, axes = plt.subplots(figsize=(5, 2.6), dpi=90)
points = axes.scatter(x[:, 0], x[:, 2], c=np.linalg.norm(v, axis=1), s=3, cmap="viridis")
axes.set(xlim=(0, 0.64), ylim=(0, 0.32), aspect="equal", xlabel="x [m]", ylabel="z [m]")
figure.colorbar(points, label="speed [m/s]", shrink=0.75)
figure.tight_layout()
figure.savefig(sys.argv[2])
