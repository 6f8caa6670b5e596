"""picture.py LOBE.vtkhdf PICTURE.png: draws the surface that `softbody` wrote, at rest and in its last step, coloured by how far it moved."""
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

with h5py.File(sys.argv[1], "r") as file:
    data = file["VTKHDF"]
    rest = data["Points"][:]
    tets = data["Connectivity"][: 4 * (len(data["Offsets"]) - 1)].reshape(-1, 4)
    moved = data["PointData/displacement"][-len(rest):]
faces = np.concatenate([tets[:, corners] for corners in ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))])
_, first, uses = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
surface = faces[first[uses == 1]]
figure = plt.figure(figsize=(5.6, 2.6), dpi=90)
colours = matplotlib.colors.Normalize(0, 1e3 * np.linalg.norm(moved, axis=1).max())
for place, x, u in ((121, rest, 0 * moved), (122, rest + moved, moved)):
    axes = figure.add_subplot(place, projection="3d")
    body = Poly3DCollection(1e3 * x[surface], edgecolor=(0, 0, 0, 0.25), linewidth=0.2)
    body.set_facecolor(plt.cm.viridis(colours(1e3 * np.linalg.norm(u, axis=1)[surface].mean(axis=1))))
    axes.add_collection3d(body)
    axes.set(xlim=(-32, 36), ylim=(-34, 34), zlim=(-6, 56), title="pulled, hanging sideways" if u.any() else "at rest")
    axes.set_axis_off()
    axes.view_init(12, -75)
    axes.set_box_aspect((68, 68, 62), zoom=1.5)
figure.colorbar(plt.cm.ScalarMappable(colours, "viridis"), ax=figure.axes, label="moved [mm]", shrink=0.8)
figure.savefig(sys.argv[2])
