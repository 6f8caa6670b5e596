"""Meshes for tests of truthcube on several ranks, and what is recorded of cases."""
import json
import random

from case_bodies import SIZE


def shuffled(*boxes):
    """These boxes beside each other as one mesh, of one box with its faces, whose nodes and tets are numbered at random."""
    seed = random.randrange(2 ** 32)
    print("seed", seed)
    shuffle = random.Random(seed).shuffle
    nodes, tets, all_of = [], [], boxes[0]
    for k, box in enumerate(boxes):
        tets += [[len(nodes) + n for n in tet] for tet in box.tets]
        nodes += [(x + 0.1 * k, y, z) for x, y, z in box.nodes]
    order = list(range(len(nodes)))
    shuffle(order), shuffle(tets)
    number = {old: new for new, old in enumerate(order)}
    all_of.nodes = [nodes[old] for old in order]
    all_of.tets = [[number[n] for n in tet] for tet in tets]
    all_of.far = [t for t, tet in enumerate(all_of.tets) if len(boxes) == 1 and all(2 * all_of.nodes[n][2] >= SIZE[2] for n in tet)]
    all_of.faces = {name: [[number[n] for n in face] for face in faces] if len(boxes) == 1 else [] for name, faces in all_of.faces.items()}
    return all_of


def case_record(folder):
    """The steps of a case without times, and what crossed."""
    run_json = json.loads((folder / "run.json").read_text())
    for step in run_json["steps"]:
        for line in (step, *step["newton"]):
            line.pop("seconds"), line.pop("warm_seconds", None)
    return run_json["steps"], run_json.get("ranks")
