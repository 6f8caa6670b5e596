"""Draws triangles into an image of values: which triangle is seen at a pixel, and values interpolated there. Colours,
light and painted lines are put over it afterwards, so one image of values serves several pictures."""
from dataclasses import dataclass

import numpy as np

SUPERSAMPLE = 2  # samples per pixel and axis
LIGHT = (-0.35, 0.75)  # along the camera's right and up; the rest comes from the viewer
SHADE = (0.78, 0.32)  # ambient, diffuse
LINE = 0.03  # half the width of painted lines, of their distance
_CANDIDATES = 4_000_000  # pixels of triangles' boxes that are looked at together


@dataclass(frozen=True)
class Camera:
    """Sees along `ahead`; lengths in metres. `distance` is that of the eye from `target`; inf is no perspective."""

    target: np.ndarray
    right: np.ndarray
    up: np.ndarray
    ahead: np.ndarray
    distance: float = np.inf

    def project(self, points):
        """@return x, y as seen in the plane through the target, and 1 / depth, which is linear over a triangle's image"""
        offset = points - self.target
        depth = offset @ self.ahead
        scale = np.ones(len(points)) if np.isinf(self.distance) else self.distance / (self.distance + depth)
        nearness = -depth if np.isinf(self.distance) else scale
        return np.column_stack([offset @ self.right * scale, offset @ self.up * scale]), nearness


def perspective(target, size, turn=-58.0, height=20.0, distance=4.5):
    """Looks at `target` from `distance` sizes away; z is up, and the angles [degree] are from x and above the ground."""
    turn, height = np.radians([turn, height])
    ahead = -np.array([np.cos(height) * np.cos(turn), np.cos(height) * np.sin(turn), np.sin(height)])
    right = np.array([-np.sin(turn), np.cos(turn), 0])
    return Camera(np.asarray(target), right, np.cross(right, ahead), ahead, distance * size)


def along_y(target):
    """Sees the plane of x (right) and z (up) without perspective."""
    return Camera(np.asarray(target), np.array([1.0, 0, 0]), np.array([0, 0, 1.0]), np.array([0, 1.0, 0]))


@dataclass(frozen=True)
class Seen:
    """An image: row 0 is on top."""

    triangle: np.ndarray  # seen at a sample, -1 where there is none
    values: np.ndarray  # rows x columns x values of the corners, interpolated
    facing: np.ndarray  # rows x columns x 3: the unit normal in the camera's right, up and towards it
    window: tuple  # left, right, bottom, top in the camera's plane [m]


def look(camera, points, triangles, values, window, pixels, closed=False):
    """The triangles as the camera sees them. @param values of the points, n x k. @param pixels of the image's
    width. @param closed whether the triangles enclose a body, seen from outside"""
    left, right, bottom, top = window
    columns = pixels * SUPERSAMPLE
    pitch = (right - left) / columns
    rows = round((top - bottom) / pitch)
    flat, nearness = camera.project(points)
    if closed:
        triangles = triangles[_turned_to(flat, triangles)]
    corners = np.column_stack([(flat[:, 0] - left) / pitch - 0.5, (top - flat[:, 1]) / pitch - 0.5])[triangles]
    sample, owner, weights = _cover(corners, rows, columns)
    near = (weights * nearness[triangles[owner]]).sum(axis=1)
    order = np.argsort(near, kind="stable")  # the nearest is written last
    seen = np.full(rows * columns, -1)
    seen[sample[order]] = order
    hit = seen >= 0
    index = seen[hit]
    shares = weights[index]
    if not np.isinf(camera.distance):  # in space, not in the image
        shares = shares * nearness[triangles[owner[index]]]
        shares /= shares.sum(axis=1, keepdims=True)
    image = np.zeros((rows * columns, values.shape[1]))
    image[hit] = (shares[:, :, None] * values[triangles[owner[index]]]).sum(axis=1)
    triangle = np.full(rows * columns, -1)
    triangle[hit] = owner[index]
    facing = np.zeros((rows * columns, 3))
    facing[hit] = _normals(camera, points, triangles)[owner[index]]
    shape = (rows, columns)
    return Seen(triangle.reshape(shape), image.reshape(*shape, -1), facing.reshape(*shape, 3), window)


def _turned_to(flat, triangles):
    """Those whose corners are counterclockwise in the image."""
    a, b, c = (flat[triangles[:, k]] for k in range(3))
    return _cross(b - a, c - a) > 0


def _cover(corners, rows, columns):
    """Which samples lie in which triangles. @return sample, triangle, weights of the three corners"""
    low = np.clip(np.ceil(corners.min(axis=1) - 1e-9), 0, [columns, rows]).astype(int)
    high = np.clip(np.floor(corners.max(axis=1) + 1e-9) + 1, 0, [columns, rows]).astype(int)
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    area = _cross(b - a, c - a)
    size = (high - low).max(axis=1)
    size[(high <= low).any(axis=1) | (area == 0)] = 0
    found = []
    for box in sorted({1 << int(s - 1).bit_length() for s in np.unique(size) if s > 0}):
        group = np.flatnonzero((size <= box) & (size > box // 2))
        y, x = np.divmod(np.arange(box * box), box)
        for part in np.array_split(group, max(1, len(group) * box * box // _CANDIDATES)):
            px, py = low[part, :1] + x, low[part, 1:] + y
            point = np.stack([px, py], axis=-1)
            of = [corners[part, k][:, None] for k in range(3)]
            w0 = _cross(of[1] - point, of[2] - point) / area[part, None]
            w1 = _cross(of[2] - point, of[0] - point) / area[part, None]
            w2 = 1 - w0 - w1
            inside = (np.minimum(np.minimum(w0, w1), w2) >= -1e-9) & (px < high[part, :1]) & (py < high[part, 1:])
            where = np.nonzero(inside)
            weights = np.column_stack([w0[where], w1[where], w2[where]])
            found.append(((py * columns + px)[where], part[where[0]], weights))
    if not found:
        return np.zeros(0, int), np.zeros(0, int), np.zeros((0, 3))
    return tuple(np.concatenate(parts) for parts in zip(*found))


def _cross(a, b):
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


def _normals(camera, points, triangles):
    """Unit normals towards the camera, in its directions."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    normal = np.cross(b - a, c - a)
    length = np.linalg.norm(normal, axis=1, keepdims=True)
    normal /= np.where(length > 0, length, 1)
    seen = np.column_stack([normal @ camera.right, normal @ camera.up, -(normal @ camera.ahead)])
    return seen * np.where(seen[:, 2:] < 0, -1, 1)


def paint(seen, colours, lines, light):
    """The picture with light and, dark, painted lines. @param colours rows x columns x 3. @param lines where they are.
    @return rows x columns x 4, transparent where nothing is seen, without supersampling"""
    picture = colours
    if light:
        towards = np.sqrt(1 - LIGHT[0] ** 2 - LIGHT[1] ** 2)
        lit = np.clip(seen.facing @ np.array([*LIGHT, towards]), 0, 1)
        picture = np.minimum(colours * (SHADE[0] + SHADE[1] * lit)[..., None], 1)
    picture = np.where(lines[..., None], picture * 0.7, picture)
    hit = seen.triangle >= 0
    picture = np.concatenate([picture * hit[..., None], hit[..., None]], axis=2)
    rows, columns = (size // SUPERSAMPLE for size in hit.shape)
    blocks = picture[: rows * SUPERSAMPLE, : columns * SUPERSAMPLE]
    mean = blocks.reshape(rows, SUPERSAMPLE, columns, SUPERSAMPLE, 4).mean(axis=(1, 3))
    share = mean[..., 3:]
    return np.concatenate([mean[..., :3] / np.where(share > 0, share, 1), share], axis=2)


def grid_lines(rest, distance, low):
    """Where lines lie that were painted onto the body at rest, `distance` apart in each coordinate. @param rest
    coordinates at rest at each sample [m]. Faces that lie along a coordinate's plane have lines of the others only"""
    marks = np.zeros(rest.shape[:2], bool)
    for axis in range(3):
        place = (rest[..., axis] - low[axis]) / distance
        from_line = np.abs(place - np.round(place))
        along = np.abs(np.gradient(rest[..., axis])).max(axis=0) < 1e-7 * distance  # this face lies in such a plane
        marks |= (from_line < LINE) & ~along
    return marks


def round_distance(size, lines=8):
    """A distance of 1, 2 or 5 times a power of ten that cuts `size` into at most about `lines` parts."""
    power = 10.0 ** np.floor(np.log10(size / lines))
    return next(step * power for step in (1, 2, 5, 10) if step * power * lines >= size * 0.999)
