#!/usr/bin/env bash
# Tests of truthcube --case as its users run it: case_test.sh RULE PROGRAM FOLDER [EXAMPLE SOURCES]
set -euo pipefail
rule=$1 program=$2 folder=$3/$1
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
export OMP_NUM_THREADS=1
. "$here/command_helpers.sh"
# A box of N^3 cells, 0.04 x 0.06 x 0.1 m times $2, in Gmsh's format, version 2.2, with groups: its faces x0 .. z1, its
# volume "body", and the point "corner" farthest from the origin.
write_mesh() {
  awk -v n="$1" -v scale="${2:-1}" '
    function corner(k) { return 1 + x + k % 2 + (n + 1) * (y + int(k / 2) % 2 + (n + 1) * (z + int(k / 4))) }
    function face(group, a, b, c) { faces = faces sprintf("%d 2 2 %d 1 %d %d %d\n", ++elements, group, corner(a), corner(b), corner(c)) }
    BEGIN {
    print "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n8"
    split("x0 x1 y0 y1 z0 z1", names, " ")
    for (g = 1; g <= 6; ++g) printf "2 %d \"%s\"\n", g, names[g]
    print "3 7 \"body\"\n0 8 \"corner\"\n$EndPhysicalNames\n$Nodes\n" (n + 1) ^ 3
    for (z = 0; z <= n; ++z) for (y = 0; y <= n; ++y) for (x = 0; x <= n; ++x)
      printf "%d %.17g %.17g %.17g\n", ++nodes, scale * .04 * x / n, scale * .06 * y / n, scale * .1 * z / n
    count = split("0137 0267 0457 0327 0517 0647", path, " ")
    for (z = 0; z < n; ++z) for (y = 0; y < n; ++y) for (x = 0; x < n; ++x) {
      for (p = 1; p <= count; ++p) {
        tets = tets (++elements) " 4 2 7 1"
        for (c = 1; c <= 4; ++c) tets = tets " " corner(substr(path[p], c, 1))
        tets = tets "\n"
      }
      if (x == 0) { face(1, 0, 2, 6); face(1, 0, 4, 6) }
      if (x == n - 1) { face(2, 1, 3, 7); face(2, 1, 5, 7) }
      if (y == 0) { face(3, 0, 1, 5); face(3, 0, 4, 5) }
      if (y == n - 1) { face(4, 2, 3, 7); face(4, 2, 6, 7) }
      if (z == 0) { face(5, 0, 1, 3); face(5, 0, 2, 3) }
      if (z == n - 1) { face(6, 4, 5, 7); face(6, 4, 6, 7) }
    }
    printf "$EndNodes\n$Elements\n%d\n%s%s%d 15 2 8 1 %d\n$EndElements\n", elements + 1, tets, faces, elements + 1, nodes
  }'
}
# case.json of the text on standard input, in which # is the mesh.
write_case() { sed 's/#/"mesh": "m.msh"/' >case.json; }
symmetric='{"group": "x0", "fixed": ["x"]}, {"group": "y0", "fixed": ["y"]}, {"group": "z0", "fixed": ["z"]}'
exactly=(--case case.json --threads 1 --precision double --tolerance 1e-12)
# check PROGRAM: runs a program of Python with run.json in `run`, groups.csv and probes.csv as lists of rows by name.
check() {
  python3 - "$1" <<'PYTHON' || fail "not so: $1"
import csv, json, pathlib, sys
run = json.load(open("o/run.json"))
steps = run["steps"]
groups = list(csv.DictReader(open("o/groups.csv")))
probes = list(csv.DictReader(open("o/probes.csv"))) if pathlib.Path("o/probes.csv").exists() else []
def near(a, b, part):
    assert abs(a - b) <= part * max(abs(a), abs(b)), (a, b)
exec(sys.argv[1])
PYTHON
}
loaded='"supports": [{"group": "z0"}, {"group": "corner", "displacement": {"x": 0.001}}],
  "loads": [{"gravity": [0, 1, -4]}, {"group": "z1", "force": [0.05, 0, 0]}, {"group": "x1", "traction": [0, 30, 0]},
    {"group": "y1", "pressure": 50}, {"group": "body", "force": [0, 0, 0.01]}, {"group": "corner", "force": [0.002, 0, 0]}]'
tissue='"material": {"law": "neo-hookean", "young": 1e4, "poisson": 0.45, "density": 1000}'

case $rule in
  a_case_pulls_a_bar_to_its_exact_length)
    write_mesh 3 >m.msh
    write_case <<<"{#, \"material\": {\"young\": 1e4, \"poisson\": 0.3}, \"supports\": [$symmetric],
      \"loads\": [{\"group\": \"z1\", \"traction\": [0, 0, 70]}], \"steps\": [0.5, 1],
      \"probes\": [{\"name\": \"end\", \"at\": [0.011, 0.02, 0.1]}]}"
    expect_exit 0 "${exactly[@]}" --scene linear-elastic --out o
    check '
assert [step["load"] for step in steps] == [0.5, 1]
for load, step in zip((0.5, 1), steps):
    near(step["probes"]["end"]["displacement"][2], load * 70 / 1e4 * 0.1, 1e-10)
    near(step["probes"]["end"]["displacement"][0], load * -0.3 * 70 / 1e4 * 0.011, 1e-10)
    near(step["groups"]["z0"]["reaction"][2], load * -70 * 0.04 * 0.06, 1e-9)
    near(step["groups"]["z1"]["load"][2], load * 70 * 0.04 * 0.06, 1e-12)
    near(step["displacement"]["z"]["high"], load * 70 / 1e4 * 0.1, 1e-10)
    near(step["displacement"]["z"]["high_at"][2], 0.1, 1e-12)
    near(step["displacement"]["y"]["low"], load * -0.3 * 70 / 1e4 * 0.06, 1e-10)
assert "held" not in run and "compression" not in steps[0] and run["settings"]["case"]["steps"] == [0.5, 1]
assert len(probes) == 2 and float(probes[1]["uz"]) == steps[1]["probes"]["end"]["displacement"][2]
assert len(groups) == 16 and groups[12]["group"] == "z0" and groups[12]["step"] == "2"
'
    [[ -s o/cube.vtkhdf ]] || fail 'no file for viewers'
    expect_exit 0 "${exactly[@]}" --set-up --out set_up
    expect out '^  arrays of levels +[0-9.]+ +[0-9.]+ '
    expect_no out '^load|solved'
    expect set_up/run.json '"steps": \[\]'
    expect_exit 1 "${exactly[@]}" --set-up --out o
    expect err '--set-up: o has the files of a run, .*; choose another --out' ;;
  reactions_balance_the_loads_and_unloading_leads_back_to_rest)
    write_mesh 4 >m.msh
    write_case <<<"{#, $tissue, $loaded, \"steps\": [0.5, 1, 0.5, 0]}"
    for flags in "" "--volume tets --preconditioner block-jacobi" "--refine 1"; do
      # shellcheck disable=SC2086
      expect_exit 0 "${exactly[@]}" $flags --out o
      check '
mass, small = 1000 * 0.04 * 0.06 * 0.1, 1e-9
load = [0.05 + 0.002, mass + 30 * 0.06 * 0.1 - 50 * 0.04 * 0.1, -4 * mass + 0.01]
for step in steps:
    factor = step["load"]
    for k in range(3):
        assert abs(step["all"]["load"][k] - factor * load[k]) < 1e-12 * mass * 4
        assert abs(step["all"]["reaction"][k] + factor * load[k]) < small * mass * 4, (step["all"], factor, load)
        both = [step["groups"][name]["reaction"][k] for name in ("z0", "corner")]
        assert abs(sum(both) - step["all"]["reaction"][k]) < 1e-12 * mass * 4
    assert step["groups"]["corner"]["reaction"][1:] == [0, 0]
assert steps[1]["displacement"]["length"]["high"] > 0.002
assert steps[3]["displacement"]["length"]["high"] < 1e-10
for k in ("x", "y", "z"):
    near(steps[0]["displacement"][k]["high"] + 1, steps[2]["displacement"][k]["high"] + 1, 1e-10)
'
    done
    expect out 'reaction of z0: [(]'
    expect_no out 'reaction of body' ;;
  loads_follow_curves_of_their_own)
    write_mesh 3 >m.msh
    write_case <<<"{#, \"material\": {\"young\": 1e4, \"poisson\": 0.3, \"density\": 1000},
      \"supports\": [{\"group\": \"z0\"}, {\"group\": \"z1\", \"displacement\": {\"x\": 0.001}, \"curve\": \"late\"}],
      \"loads\": [{\"gravity\": [0, 0, -2], \"curve\": \"always\"}, {\"group\": \"z1\", \"force\": [0, 0.01, 0], \"curve\": \"breath\"},
        {\"group\": \"y1\", \"pressure\": 20}],
      \"curves\": {\"always\": [[0, 1]], \"breath\": [[0, 0], [1, 1], [2, 0]], \"late\": [[1, 0], [2, 1]]},
      \"steps\": [0, 0.5, 1, 2, 0]}"
    for flags in "" "--scene linear-elastic" "--refine 1"; do
      # shellcheck disable=SC2086
      expect_exit 0 "${exactly[@]}" $flags --out o
      check '
mass = 1000 * 0.04 * 0.06 * 0.1
assert [step["load"] for step in steps] == [0, 0.5, 1, 2, 0]
for step, breath, late in zip(steps, (0, 0.5, 1, 0, 0), (0, 0, 0, 1, 0)):
    load = [0, 0.01 * breath - step["load"] * 20 * 0.04 * 0.1, -2 * mass]
    for k in range(3):
        assert abs(step["all"]["load"][k] - load[k]) < 1e-12, (step["load"], step["all"]["load"], load)
        assert abs(step["all"]["reaction"][k] + load[k]) < 1e-9, (step["load"], step["all"]["reaction"], load)
    assert step["displacement"]["x"]["high"] > 0.001 * late - 1e-12, step["displacement"]
near(steps[0]["displacement"]["z"]["low"] + 1, steps[4]["displacement"]["z"]["low"] + 1, 1e-10)
assert steps[0]["displacement"]["z"]["low"] < -1e-6
'
    done ;;
  groups_have_materials_of_their_own)
    # Two halves side by side with the constants of one, and a stiff layer at the end that is pulled.
    write_mesh 4 | awk '/^\$PhysicalNames/ { print; getline; print $1 + 1; print "3 9 \"far\""; next }
      $2 == 4 && $3 == 2 && NF == 9 { if ($6 > 50 && $7 > 50 && $8 > 50 && $9 > 50) $4 = 9 } { print }' >m.msh
    write_case <<<"{#, \"material\": {\"young\": 1e4, \"poisson\": 0, \"density\": 1000,
        \"groups\": [{\"group\": \"far\", \"young\": 4e4, \"poisson\": 0, \"density\": 3000}]},
      \"supports\": [$symmetric], \"loads\": [{\"group\": \"z1\", \"traction\": [0, 0, 3000]}], \"probes\": [{\"name\": \"middle\", \"at\": [0.02, 0.03, 0.05]}]}"
    for flags in "" "--refine 1 --volume tets" "--volume tets --preconditioner block-jacobi"; do
      # shellcheck disable=SC2086
      expect_exit 0 "${exactly[@]}" $flags --out o
      # mu (s - 1/s) = traction, mu = E / 2: each half has its own stretch
      check '
def stretch(young):
    a = 3000 / (young / 2)
    return (a + (a * a + 4) ** 0.5) / 2
soft, stiff = stretch(1e4), stretch(4e4)
near(steps[0]["probes"]["middle"]["displacement"][2], 0.05 * (soft - 1), 1e-7)
near(steps[0]["displacement"]["z"]["high"], 0.05 * (soft - 1) + 0.05 * (stiff - 1), 1e-7)
near(steps[0]["groups"]["z0"]["reaction"][2], -3000 * 0.04 * 0.06, 1e-7)
'
    done
    sed -i 's/"loads".*"probes"/"loads": [{"gravity": [0, 0, 1]}], "probes"/' case.json
    expect_exit 0 "${exactly[@]}" --out o
    check 'near(steps[0]["all"]["load"][2], (1000 + 3000) / 2 * 0.04 * 0.06 * 0.1, 1e-9)'
    expect_exit 1 --case case.json --volume nodes
    expect err 'volumes averaged at nodes would mix the materials around a node'
    expect_exit 1 --case case.json --scene linear-elastic
    expect err 'linear elasticity has one material; give the body one' ;;
  a_pressure_that_follows_squeezes_a_body_from_all_sides)
    write_mesh 3 >m.msh
    loads=
    for group in x0 x1 y0 y1 z0 z1; do loads+="${loads:+, }{\"group\": \"$group\", \"pressure\": 4000, \"follows\": true}"; done
    write_case <<<"{#, \"material\": {\"young\": 1e4, \"poisson\": 0.4}, \"supports\": [$symmetric], \"loads\": [$loads], \"steps\": [0.5, 1, 0]}"
    for flags in "" "--refine 1" "--volume nodes"; do
      # shellcheck disable=SC2086
      expect_exit 0 "${exactly[@]}" $flags --out o
      check '
import math
mu, lam = 1e4 / 2.8, 1e4 * 0.4 / (1.4 * 0.2)
for step in steps:
    low, high = 0.3, 1.5
    for _ in range(100):
        s = (low + high) / 2
        low, high = (s, high) if mu * (s * s - 1) + 3 * lam * math.log(s) < -4000 * step["load"] * s ** 3 else (low, s)
    assert abs(step["displacement"]["z"]["low"] - 0.1 * (low - 1)) < 1e-9, (step["load"], low)
    assert max(abs(x) for x in step["all"]["reaction"] + step["all"]["load"]) < 1e-7
    near(1 + step["groups"]["z1"]["load"][2], 1 - 4000 * step["load"] * low ** 2 * 0.04 * 0.06, 1e-7)
'
    done
    expect_exit 1 --case case.json --product matrix-free --preconditioner block-jacobi
    expect err 'pressures that follow the surface require the assembled product' ;;
  a_case_in_millimetres_is_the_same)
    write_mesh 4 >m.msh
    write_case <<<"{#, $tissue, $loaded}"
    expect_exit 0 "${exactly[@]}" --out o
    cp o/run.json metres.json
    write_mesh 4 1000 >m.msh
    mkdir deeper
    write_case <<<"{// of another folder
      \"mesh\": \"../m.msh\", \"scale\": 0.001, $tissue, $loaded}"
    mv case.json deeper
    expect_exit 0 "${exactly[@]:2}" --case deeper/case.json --out o
    check '
other = json.load(open("metres.json"))["steps"]
for k in ("x", "y", "z"):
    near(steps[0]["displacement"][k]["high"], other[0]["displacement"][k]["high"], 1e-7)
' ;;
  a_case_that_is_not_understood_is_refused_with_its_place)
    write_mesh 1 >m.msh
    refused() { # pattern, text of the case
      write_case <<<"$2"
      expect_refused "case case.json: $1" --case case.json
    }
    rest="$tissue, \"supports\": [{\"group\": \"z0\"}]"
    refused "there is no key 'lods' here; did you mean 'loads'[?] there are mesh, scale" "{#, $rest, \"lods\": []}"
    refused "loads\[1\]: there is no key 'preasure' here; did you mean 'pressure'" \
      "{#, $rest, \"loads\": [{\"gravity\": [0, 0, 1]}, {\"group\": \"z1\", \"preasure\": 1}]}"
    refused "loads\[0\]: a load has one of force, traction, pressure, gravity, not 2" \
      "{#, $rest, \"loads\": [{\"group\": \"z1\", \"force\": [0, 0, 1], \"pressure\": 1}]}"
    refused 'loads\[0\].force: this must be 3 numbers, along x, y and z, not 2' "{#, $rest, \"loads\": [{\"group\": \"z1\", \"force\": [0, 0]}]}"
    refused 'loads\[0\].force\[1\]: this must be a number, not "a"' "{#, $rest, \"loads\": [{\"group\": \"z1\", \"force\": [0, \"a\", 1]}]}"
    refused "loads\[0\]: there is no key 'curv' here; did you mean 'curve'" "{#, $rest, \"loads\": [{\"gravity\": [0, 0, 1], \"curv\": \"a\"}]}"
    refused "loads: there is no curve 'beath'; did you mean 'breath'" \
      "{#, $rest, \"loads\": [{\"gravity\": [0, 0, 1], \"curve\": \"beath\"}], \"curves\": {\"breath\": [[0, 1]]}}"
    refused "curves: no load names the curve 'idle'; remove it" "{#, $rest, \"curves\": {\"idle\": [[0, 1]]}}"
    refused "curves.a: the curve 'a' does not ascend at point 1" "{#, $rest, \"curves\": {\"a\": [[1, 0], [1, 1]]}}"
    refused 'curves.a\[0\]: this must be a step and a factor, not 3 numbers' "{#, $rest, \"curves\": {\"a\": [[1, 0, 2]]}}"
    refused 'loads\[0\].follows: only a pressure follows the surface' "{#, $rest, \"loads\": [{\"group\": \"z1\", \"force\": [0, 0, 1], \"follows\": true}]}"
    refused 'loads\[0\].follows: this must be true or false' "{#, $rest, \"loads\": [{\"group\": \"z1\", \"pressure\": 1, \"follows\": 1}]}"
    refused "material.groups\[0\].law: all of a body has one law, which stands in 'material'" \
      "{#, \"material\": {\"young\": 1, \"poisson\": 0, \"groups\": [{\"group\": \"body\", \"law\": \"corotated\", \"young\": 1, \"poisson\": 0}]}, \"supports\": []}"
    refused "material.groups\[0\]: the key 'young' is missing" "{#, \"material\": {\"young\": 1, \"poisson\": 0, \"groups\": [{\"group\": \"body\"}]}, \"supports\": []}"
    refused 'steps\[1\]: the load 1 is that of the step before' "{#, $rest, \"steps\": [1, 1]}"
    refused 'steps\[0\]: the load 0 is that at rest' "{#, $rest, \"steps\": [0, 1]}"
    refused "material.law: there is no material neo-hooken; did you mean neo-hookean" \
      "{#, \"material\": {\"law\": \"neo-hooken\", \"young\": 1, \"poisson\": 0}, \"supports\": []}"
    refused 'material.poisson: 0.5 must be above -1 and below 0.5' "{#, \"material\": {\"young\": 1, \"poisson\": 0.5}, \"supports\": []}"
    refused "material: gravity needs the key 'density'" \
      "{#, \"material\": {\"young\": 1, \"poisson\": 0}, \"supports\": [], \"loads\": [{\"gravity\": [0, 0, 1]}]}"
    refused "supports\[0\].fixed\[1\]: there is no component 'w'; there are x, y, z" "{#, $tissue, \"supports\": [{\"group\": \"z0\", \"fixed\": [\"x\", \"w\"]}]}"
    refused "supports\[0\].fixed\[0\]: component 'x' is prescribed here twice" \
      "{#, $tissue, \"supports\": [{\"group\": \"z0\", \"fixed\": [\"x\"], \"displacement\": {\"x\": 1}}]}"
    refused "the key 'steps' stands twice in one object" "{#, $rest, \"steps\": [1], \"steps\": [2]}"
    refused "the key 'mesh' is missing" "{$rest}"
    refused 'this is not JSON: .*line 1, column [0-9]+' "{#, $rest,, }"
    expect_refused 'case none.json: cannot be read' --case none.json ;;
  a_body_that_nothing_holds_is_refused_with_its_rigid_motions)
    write_mesh 2 >m.msh
    write_case <<<"{#, $tissue, \"supports\": [{\"group\": \"z0\", \"fixed\": [\"z\"]}], \"loads\": [{\"gravity\": [0, 0, -1]}]}"
    expect_exit 1 --case case.json
    expect err 'nothing keeps the body from moving as a rigid body: translation along x, translation along y, rotation about z;'
    write_case <<<"{#, $tissue, \"supports\": []}"
    expect_exit 1 --case case.json
    expect err 'translation along z, rotation about x, rotation about y, rotation about z; add supports' ;;
  a_group_that_the_mesh_lacks_is_refused_with_the_nearest)
    write_mesh 2 >m.msh
    write_case <<<"{#, $tissue, \"supports\": [{\"group\": \"z0\"}], \"loads\": [{\"group\": \"bdoy\", \"force\": [0, 0, 1]}]}"
    expect_exit 1 --case case.json
    expect err "the mesh has no group 'bdoy'; did you mean 'body'[?] It has x0, x1, y0, y1, z0, z1, body, corner"
    write_case <<<"{#, $tissue, \"supports\": [{\"group\": \"z0\"}], \"probes\": [{\"name\": \"far\", \"at\": [0, 0, 1]}]}"
    expect_exit 1 --case case.json
    expect err "the probe 'far' at [(]0, 0, 1[)] m lies outside of the body" ;;
  flags_that_a_case_takes_the_place_of_are_refused)
    write_mesh 1 >m.msh
    write_case <<<"{#, $tissue, \"supports\": [{\"group\": \"z0\"}]}"
    for flags in "--cells 4" "--mesh m.msh" "--young 1" "--compress 0.1" "--top bonded" "--beads b.csv" "--repeat 1" "--historical"; do
      # shellcheck disable=SC2086
      expect_refused "--case cannot take ${flags%% *}, because .*; remove ${flags%% *}" --case case.json $flags
    done
    expect_refused '--case cannot take --restart' --case case.json --out o --restart
    expect_refused '--case cannot take --scene explicit-dynamics' --case case.json --scene explicit-dynamics
    expect_refused 'material.law: --scene linear-elastic has a law of its own' --case case.json --scene linear-elastic
    expect_exit 0 --case case.json --dry-run
    expect out '^solver: [0-9]+ bytes' ;;
  no_equilibrium_of_a_case_exits_with_3_and_keeps_the_steps_before)
    write_mesh 2 >m.msh
    write_case <<<"{#, $tissue, \"supports\": [{\"group\": \"z0\"}, {\"group\": \"z1\", \"displacement\": {\"x\": 0, \"y\": 0, \"z\": -0.1}}], \"steps\": [0.05, 1.5]}"
    expect_exit 3 --case case.json --threads 1 --out o
    expect err 'no equilibrium at a load of 1.5: .*the last equilibrium is at'
    expect err 'Try more and smaller steps in the case'
    check 'assert [step["load"] for step in steps] == [0.05]' ;;
  the_example_softbody_gives_the_reactions_of_its_case)
    example=$5
    cp "$example/case.json" .
    python3 "$example/lobe.py" 12 lobe.msh
    expect_exit 0 --case case.json --threads 1 --out o
    check '
mass = steps[1]["all"]["load"][0] / 9.81
assert 0.1 < mass < 0.2, mass  # [kg] of 60 x 60 x 50 mm at most
for step in steps:
    for k, load in enumerate((9.81 * mass, 0.1, 0.05)):
        assert abs(step["all"]["reaction"][k] + step["load"] * load) < 1e-3 * mass * 9.81
print(*("load %g: reaction of base (%.5g, %.5g, %.5g) N" % (step["load"], *step["groups"]["base"]["reaction"]) for step in steps), sep="\n")
' >expected
    "$4" lobe.msh >printed
    expect_same expected printed
    [[ -s lobe.vtkhdf ]] || fail 'no file for viewers'
    while read -r line; do grep -qF -- "$line" "$example/README.md" || fail "the page lacks: $line"; done <printed ;;
  *) fail 'no such rule' ;;
esac
