"""Parts of tet meshes that are drawn: the surface, and a cut along a plane."""
import numpy as np

_FACES = np.array([[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]])
_EDGES = np.array([[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]])


def surface(tets):
    """Triangles that belong to one tet only, m x 3 nodes."""
    faces = tets[:, _FACES].reshape(-1, 3)
    ordered = np.sort(faces, axis=1)
    order = np.lexsort(ordered.T)
    ordered = ordered[order]
    same = (ordered[1:] == ordered[:-1]).all(axis=1)
    alone = np.ones(len(faces), bool)
    alone[1:] &= ~same
    alone[:-1] &= ~same
    return faces[np.sort(order[alone])]


def cut(points, tets, axis, place):
    """Where the plane of points[:, axis] == place cuts the tets, as triangles whose corners lie on edges of the mesh.
    A plane through nodes is taken as one just above them, so that faces in it count once.

    @return edges (e x 2 nodes), share (e: a corner is at (1 - share) of the first node and share of the second),
    triangles (m x 3 of these corners)"""
    height = points[:, axis] - place
    above = height > 1e-9 * np.ptp(points[:, axis])
    sides = above[tets].sum(axis=1)
    crossed = tets[(sides > 0) & (sides < 4)]
    ends = crossed[:, _EDGES]  # tets x 6 x 2
    cutting = above[ends[..., 0]] != above[ends[..., 1]]
    triangles = []
    for count in (3, 4):
        of = np.flatnonzero(cutting.sum(axis=1) == count)
        corners = ends[of][cutting[of]].reshape(len(of), count, 2)
        # The first and the last of four corners, in the order of _EDGES, have no common face: they are opposite.
        for chosen in ([0, 1, 2],) if count == 3 else ([0, 1, 3], [0, 2, 3]):
            triangles.append(corners[:, chosen])
    corners = np.sort(np.concatenate(triangles).reshape(-1, 2), axis=1)
    edges, index = np.unique(corners, axis=0, return_inverse=True)
    a, b = height[edges[:, 0]], height[edges[:, 1]]
    share = np.clip(a / (a - b), 0, 1)  # outside by the allowance for nodes in the plane only
    return edges, share, index.reshape(-1, 3)


def on_edges(values, edges, share):
    """Values of nodes, at corners of a cut."""
    share = share.reshape(-1, *[1] * (values.ndim - 1))
    return (1 - share) * values[edges[:, 0]] + share * values[edges[:, 1]]


def box_edges(points, tolerance=1e-6):
    """For a body that fills its bounding box at rest: for each of the box's 12 edges the nodes on it, in order."""
    low, high = points.min(axis=0), points.max(axis=0)
    found = []
    for axis in range(3):
        others = [k for k in range(3) if k != axis]
        for sides in ((0, 0), (0, 1), (1, 0), (1, 1)):
            at = [(low, high)[side][k] for side, k in zip(sides, others)]
            near = np.abs(points[:, others] - at).max(axis=1) < tolerance * (high - low).max()
            nodes = np.flatnonzero(near)
            found.append(nodes[np.argsort(points[nodes, axis])])
    return found
