"""Tests of truthcube --order: order_test.py PROGRAM ON|OFF, the last saying whether the build has METIS."""
import csv
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
PROGRAM, HAS_METIS = str(pathlib.Path(sys.argv[1]).resolve()), sys.argv[2] == "ON"
del sys.argv[1:3]
import h5py  # noqa: E402
import numpy as np  # noqa: E402

SEED = random.randrange(2**32)
EXACTLY = ("--precision", "double", "--tolerance", "1e-10")
PATHS = ("0137", "0267", "0457", "0327", "0517", "0647")  # tets of a cell, by the bits of their corners


def write_mesh(path, cells, seed=SEED, width=0.08):
    """A box of cells^3 cells in Gmsh's format, inner nodes moved and all numbered at random; groups low, high, body, core."""
    shuffled = random.Random(seed)
    side = cells + 1
    tags = list(range(1, side**3 + 1))
    shuffled.shuffle(tags)

    def node(x, y, z, corner):
        return tags[x + corner % 2 + side * (y + corner // 2 % 2 + side * (z + corner // 4))]

    triangles, tets = [], []
    for z in range(cells):
        for y in range(cells):
            for x in range(cells):
                corner = [node(x, y, z, c) for c in range(8)]
                tets += [(4 if max(x, y, z) < cells / 2 else 3, [corner[int(c)] for c in path]) for path in PATHS]
                if z == 0:
                    triangles += [(1, [corner[c] for c in face]) for face in ((0, 3, 1), (0, 2, 3))]
                if z == cells - 1:
                    triangles += [(2, [corner[c] for c in face]) for face in ((4, 5, 7), (4, 7, 6))]
    shuffled.shuffle(tets)
    nodes = {}
    for k, tag in enumerate(tags):
        place = (k % side, k // side % side, k // side**2)
        nodes[tag] = [width / cells * (c + (shuffled.uniform(-0.1, 0.1) if 0 < c < cells else 0)) for c in place]
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "4", '2 1 "low"', '2 2 "high"', '3 3 "body"', '3 4 "core"']
    lines += ["$EndPhysicalNames", "$Nodes", str(len(nodes))]
    lines += [f"{tag} {x!r} {y!r} {z!r}" for tag, (x, y, z) in sorted(nodes.items())]
    lines += ["$EndNodes", "$Elements", str(len(triangles) + len(tets))]
    elements = [(2, *triangle) for triangle in triangles] + [(4, *tet) for tet in tets]
    lines += [f"{k + 1} {kind} 2 {group} 1 {' '.join(map(str, corners))}" for k, (kind, group, corners) in enumerate(elements)]
    path.write_text("\n".join([*lines, "$EndElements", ""]))


class OrderTest(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)
        write_mesh(self.folder / "m.msh", 6)

    def tearDown(self):
        self.temporary.cleanup()

    def truthcube(self, *arguments, status=0):
        command = [PROGRAM, *map(str, arguments)]
        done = subprocess.run(command, cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, status, f"seed {SEED}: {command}\n{done.stdout}{done.stderr}")
        return done.stdout, done.stderr

    def run_mesh(self, out, *flags, status=0, threads=1):
        return self.truthcube("--mesh", "m.msh", "--threads", threads, "--out", out, *flags, status=status)

    def record(self, out):
        return json.loads((self.folder / out / "run.json").read_text())

    def drawn(self, out):
        """The datasets of cube.vtkhdf by name."""
        found = {}
        with h5py.File(self.folder / out / "cube.vtkhdf") as file:
            file.visititems(lambda name, item: found.update({name: item[()]}) if isinstance(item, h5py.Dataset) else None)
        return found

    def order(self, out):
        with h5py.File(self.folder / out / "order.h5") as file:
            return file["nodes"][()], file["tets"][()]

    def assert_same_state(self, one, other, part):
        """The same mesh, and fields of all steps that differ by so much of their largest value."""
        mine, others = self.drawn(one), self.drawn(other)
        self.assertEqual(set(mine), set(others))
        for name, values in mine.items():
            what = f"{name}, seed {SEED}"
            self.assertEqual(values.shape, others[name].shape, what)
            if "Data/" in name and "Offsets" not in name:
                self.assertLess(np.abs(values - others[name]).max(), part * np.abs(values).max(), what)
            else:
                np.testing.assert_array_equal(values, others[name], what)


@unittest.skipUnless(HAS_METIS, "this build has no METIS (libmetis-dev)")
class OrdersByPartsTest(OrderTest):
    def test_files_keep_the_numbers_of_the_mesh_and_have_the_same_state(self):
        for k, flags in enumerate(
            (
                ("--volume", "tets", "--compress", "0.05", "0.1"),
                ("--volume", "patches", "--compress", "0.05"),
                ("--volume", "nodes", "--compress", "0.05"),
                ("--refine", "1", "--compress", "0.05"),
                ("--scene", "implicit-dynamics", "--frames", "3", "--volume", "patches"),
            )
        ):
            with self.subTest(flags=flags):
                self.run_mesh(f"a{k}", *EXACTLY, *flags)
                self.run_mesh(f"b{k}", *EXACTLY, *flags, "--order", "metis")
                self.assert_same_state(f"a{k}", f"b{k}", 2e-6)  # files have floats
                nodes, tets = self.order(f"b{k}")
                self.assertEqual(sorted(nodes), list(range(343)))
                self.assertEqual(sorted(tets), list(range(6 * 216)))
                self.assertNotEqual(list(nodes), sorted(nodes))
                self.assertEqual(self.record(f"b{k}")["settings"]["order"], "metis")
                self.assertNotIn("order", self.record(f"a{k}")["settings"])
                self.assertFalse((self.folder / f"a{k}" / "order.h5").exists())
                for mine, others in zip(self.record(f"a{k}")["steps"], self.record(f"b{k}")["steps"]):
                    self.assertAlmostEqual(mine["reaction"] / others["reaction"], 1, delta=1e-7)

    def test_groups_loads_curves_materials_and_probes_of_a_case_follow(self):
        case = {
            "mesh": "m.msh",
            "material": {
                "young": 6e3, "poisson": 0.45, "density": 1000,
                "groups": [{"group": "core", "young": 3e4, "poisson": 0.4, "density": 2000}],
            },
            "supports": [{"group": "low"}],
            "loads": [
                {"gravity": [0, 0, -9.81]}, {"group": "high", "traction": [30, 0, 0]},
                {"group": "high", "pressure": 50, "follows": True, "curve": "up"}, {"group": "core", "force": [0, 0.02, 0]},
            ],
            "curves": {"up": [[0, 0], [1, 1], [2, 0]]},
            "steps": [1, 2],
            "probes": [{"name": "middle", "at": [0.041, 0.043, 0.04]}],
        }  # fmt: skip
        (self.folder / "case.json").write_text(json.dumps(case))
        for refined in ("0", "1"):
            flags = ("--case", "case.json", "--threads", "1", *EXACTLY, "--refine", refined)
            self.truthcube(*flags, "--out", "a" + refined)
            self.truthcube(*flags, "--out", "b" + refined, "--order", "metis")
            self.assert_same_state("a" + refined, "b" + refined, 2e-6)
            for name in ("groups.csv", "probes.csv"):
                texts = ((self.folder / (out + refined) / name).read_text() for out in "ab")
                mine, others = (list(csv.DictReader(text.splitlines())) for text in texts)
                self.assertGreater(len(mine), 1)
                for row, other in zip(mine, others, strict=True):
                    for key, value in row.items():
                        if key in ("group", "probe"):
                            self.assertEqual(value, other[key])
                        else:
                            self.assertAlmostEqual(float(value), float(other[key]), delta=1e-8, msg=f"{name}: {key}, seed {SEED}")
        case["supports"].append({"group": "low", "displacement": {"x": 0.01}})
        (self.folder / "case.json").write_text(json.dumps(case))
        for order in ("mesh", "metis"):
            said = self.truthcube("--case", "case.json", "--order", order, status=1)[1]
            self.assertRegex(said, r"share the node at \(0[.0-9]*, 0[.0-9]*, 0\) m at rest and prescribe different displacements")

    def test_a_restart_has_the_bits_of_a_run_that_was_not_stopped(self):
        for flags in (("--refine", "1"), ("--volume", "tets")):
            name = flags[1]
            self.run_mesh(f"whole{name}", *flags, "--order", "metis", "--compress", "0.03", "0.06")
            self.run_mesh(f"parts{name}", *flags, "--order", "metis", "--compress", "0.03")
            before = self.order(f"parts{name}")
            self.run_mesh(f"parts{name}", *flags, "--order", "metis", "--compress", "0.03", "0.06", "--restart")
            for mine, others in zip(before, self.order(f"parts{name}")):
                np.testing.assert_array_equal(mine, others)
            whole, parts = self.drawn(f"whole{name}"), self.drawn(f"parts{name}")
            for key, values in whole.items():
                self.assertEqual(values.tobytes(), parts[key].tobytes(), key)
            with h5py.File(self.folder / f"whole{name}/checkpoint.h5") as mine, h5py.File(self.folder / f"parts{name}/checkpoint.h5") as other:
                self.assertEqual(mine["positions"][()].tobytes(), other["positions"][()].tobytes())
                self.assertEqual(mine.attrs["checksum"], other.attrs["checksum"])

    def test_an_order_is_the_same_on_every_run_and_any_threads(self):
        for out, threads in (("a", 1), ("b", 1), ("c", 2)):
            self.run_mesh(out, "--order", "metis", "--compress", "0.01", threads=threads)
        for out in "bc":
            for mine, others in zip(self.order("a"), self.order(out)):
                np.testing.assert_array_equal(mine, others)

    def test_a_restart_in_another_order_is_refused_with_the_flag_to_add(self):
        self.run_mesh("own", "--compress", "0.01")
        self.run_mesh("metis", "--compress", "0.01", "--order", "metis")
        said = self.run_mesh("own", "--compress", "0.01", "0.02", "--restart", "--order", "metis", status=1)[1]
        self.assertRegex(said, r"own/checkpoint.h5: this checkpoint has its nodes in another order .*; add --order mesh\n")
        said = self.run_mesh("metis", "--compress", "0.01", "0.02", "--restart", status=1)[1]
        self.assertRegex(said, r"metis/checkpoint.h5: this checkpoint has its nodes in another order .*; add --order metis\n")

    def test_a_restart_refuses_an_order_that_is_not_that_of_its_mesh_and_checkpoint(self):
        flags = ("--compress", "0.01", "0.02", "--order", "metis", "--restart")
        self.run_mesh("a", "--compress", "0.01", "--order", "metis")
        file = self.folder / "a/order.h5"
        good = file.read_bytes()
        file.unlink()
        self.assertRegex(self.run_mesh("a", *flags, status=1)[1], "a/order.h5: the order of this run's mesh does not exist; remove --restart")
        file.write_bytes(b"no order")
        self.assertRegex(self.run_mesh("a", *flags, status=1)[1], "a/order.h5: this file is damaged, or is not the order of a mesh")
        file.write_bytes(good)
        with h5py.File(file, "r+") as stored:
            stored["nodes"][:2] = stored["nodes"][:2][::-1]
        self.assertRegex(self.run_mesh("a", *flags, status=1)[1], "a/order.h5: is damaged: its checksum is not that of its contents")
        file.write_bytes(good)
        write_mesh(self.folder / "m.msh", 6, seed=SEED + 1)
        self.assertRegex(
            self.run_mesh("a", *flags, status=1)[1], r"a/order.h5: this order belongs to another mesh, of 343 nodes and 1296 tets; give the --mesh"
        )

    def test_a_run_without_an_order_drops_that_of_an_old_run(self):
        self.run_mesh("a", "--compress", "0.01", "--order", "metis")
        self.run_mesh("a", "--compress", "0.01")
        self.assertFalse((self.folder / "a/order.h5").exists())

    def test_tets_in_messages_have_the_numbers_of_the_mesh(self):
        for refined, words in (("0", "element"), ("1", "part of element")):
            flags = ("--scene", "linear-elastic", "--compress", "0.99", "--refine", refined, *EXACTLY)
            said = [self.run_mesh("a", *flags, "--order", order)[1] for order in ("mesh", "metis")]
            named = [re.search(rf"tet (\d+) \({words} (\d+) of the mesh file\): J -[0-9.]+, F = ", text) for text in said]
            self.assertIsNotNone(named[0], said)
            self.assertIsNotNone(named[1], said)
            self.assertEqual(named[0].groups(), named[1].groups(), said)

    def test_a_dry_run_says_the_bytes_that_a_run_takes(self):
        said = re.search(r"solver: (\d+) bytes", self.truthcube("--mesh", "m.msh", "--order", "metis", "--dry-run")[0])
        self.run_mesh("a", "--order", "metis", "--set-up")
        self.assertEqual(int(said[1]), self.record("a")["bytes"])
        self.assertFalse((self.folder / "a/order.h5").exists())


class OrderFlagTest(OrderTest):
    def test_the_cube_has_no_other_order(self):
        for order in ("mesh", "metis"):
            said = self.truthcube("--cells", "2", "--order", order, status=2)[1]
            self.assertIn("--order is for a mesh of your own: the cube's order is fixed; remove --order", said)

    def test_an_unknown_order_is_refused_with_all_that_there_are(self):
        said = self.truthcube("--mesh", "m.msh", "--order", "meits", status=2)[1]
        self.assertIn("--order: there is no order meits; did you mean metis? This build has mesh, metis", said)

    @unittest.skipIf(HAS_METIS, "this build has METIS")
    def test_without_metis_its_package_is_named(self):
        said = self.truthcube("--mesh", "m.msh", "--order", "metis", status=2)[1]
        self.assertIn("--order metis: this build has no METIS; install libmetis-dev and configure with -DPHYSGEN_METIS=ON", said)
        self.run_mesh("a", "--order", "mesh", "--compress", "0.01")


if __name__ == "__main__":
    unittest.main()
