"""picture.py FOLDER PICTURE.svg: draws the rows and columns of the sheet that `cloth FOLDER` saved."""
import sys

import numpy as np

x = np.load(sys.argv[1] + "/x.npy")
side = round(len(x) ** 0.5)
grid = x.reshape(side, side, 3)
with open(sys.argv[2], "w", encoding="ascii") as file:
    file.write('<svg xmlns="http://www.w3.org/2000/svg" viewBox="-20 -20 440 300" fill="none" stroke="#0072B2">\n')
    for line in [*grid, *grid.transpose(1, 0, 2)]:
        points = " ".join(f"{300 * x + 100 * y:.0f},{-220 * z - 40 * y + 40:.0f}" for x, y, z in line)
        file.write(f'<polyline points="{points} "/>\n')
    file.write("</svg>\n")
