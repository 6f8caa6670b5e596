"""picture.py POSITIONS.txt PICTURE.png: draws what `particles POSITIONS.txt` wrote, from the side, coloured by speed."""
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

rows = [[float(word) for word in line.split()] for line in open(sys.argv[1])]
x, z, speed = zip(*rows)
figure, axes = plt.subplots(figsize=(5, 2.6), dpi=90)
points = axes.scatter(x, z, c=speed, s=3, cmap="viridis")
axes.set(xlim=(0, 0.64), ylim=(0, 0.32), aspect="equal", xlabel="x [m]", ylabel="z [m]")
figure.colorbar(points, label="speed [m/s]", shrink=0.75)
figure.tight_layout()
figure.savefig(sys.argv[2])
