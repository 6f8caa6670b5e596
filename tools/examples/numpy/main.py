"""Bodies round the sun: NumPy sets them up and looks at them, a kernel of C++ moves them, and both see the same memory.
`main.py --picture FILE` draws some of the orbits (with matplotlib). Exit status 1 where the results are not as they must be."""
import sys

import numpy as np
import solar

PULL = 4 * np.pi**2  # GM of the sun in au^3/year^2
COUNT, DT, STEPS = 20_000, 0.001, 1_000


def energy(bodies):
    """Per mass, of each body; calculated by NumPy from the arrays' own memory."""
    return 0.5 * (bodies.v**2).sum(axis=1) - PULL / np.linalg.norm(bodies.x, axis=1)


def bodies_at(count):
    bodies = solar.Body(count, precision="double")
    radius, angle = np.linspace(0.4, 2, count), np.linspace(0, 40, count)
    speed = np.sqrt(PULL / radius) * np.linspace(0.8, 1.1, count)
    x, v = bodies.x, bodies.v  # views: what is written here is in the array
    x[:, 0], x[:, 1] = radius * np.cos(angle), radius * np.sin(angle)
    v[:, 0], v[:, 1] = -speed * np.sin(angle), speed * np.cos(angle)
    v[:, 2] = 0.1 * speed
    return bodies


def picture(file):
    import matplotlib
    matplotlib.use("svg")
    from matplotlib import pyplot
    bodies = bodies_at(6)
    figure, axes = pyplot.subplots(figsize=(4, 4))
    paths = []
    for _ in range(150):
        solar.move(bodies, DT, 12, PULL)
        paths.append(bodies.x.copy())
    for path in np.array(paths).round(2).transpose(1, 2, 0):
        axes.plot(path[0], path[1], linewidth=1)
    axes.plot(0, 0, "o", color="orange")
    axes.set(aspect="equal", xlabel="x [au]", ylabel="y [au]")
    figure.savefig(file, bbox_inches="tight")


def main():
    bodies = bodies_at(COUNT)
    x, v, before = bodies.x.copy(), bodies.v.copy(), energy(bodies)
    view = bodies.x
    solar.move(bodies, DT, STEPS, PULL)
    for _ in range(STEPS):  # the same by NumPy alone
        v -= DT * PULL * x / np.linalg.norm(x, axis=1)[:, None]**3
        x += DT * v
    unlike = abs(view - x).max()
    change = abs(energy(bodies) / before - 1).max()
    try:
        bodies.resize(10)
        refused = "IT IS NOT"
    except BufferError:
        refused = "is refused"
    print(f"bodies                            {len(bodies)}")
    print(f"positions unlike NumPy's own      {unlike:.1e} au")
    print(f"largest change of energy          {change:.1e}")
    print(f"resize() under a view             {refused}")
    return 0 if unlike < 1e-9 and change < 0.05 and refused == "is refused" else 1


if __name__ == "__main__":
    sys.exit(picture(sys.argv[2]) if sys.argv[1:2] == ["--picture"] else main())
