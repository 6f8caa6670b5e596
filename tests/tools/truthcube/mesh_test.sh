#!/usr/bin/env bash
# Tests of the command truthcube with meshes in the place of the cube: mesh_test.sh RULE PROGRAM FOLDER [LAYOUT]
set -euo pipefail
rule=$1 program=$2 folder=$3/$1 built=${4:-schema} # the layout
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
export OMP_NUM_THREADS=1

. "$here/command_helpers.sh"
# A box of N^3 cells and 0.08 m in Gmsh's format, version 2.2; tet number $2, if given, has two corners exchanged. Cells
# from number $3 on, if given, along each axis are cut as the mirror images of the others.
write_mesh() {
  awk -v n="$1" -v inverted="${2:-0}" -v mirrored="${3:-$1}" 'BEGIN {
    print "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" (n + 1) ^ 3
    for (z = 0; z <= n; ++z) for (y = 0; y <= n; ++y) for (x = 0; x <= n; ++x)
      printf "%d %.17g %.17g %.17g\n", ++nodes, .08 * x / n, .08 * y / n, .08 * z / n
    print "$EndNodes\n$Elements\n" 6 * n ^ 3
    count = split("0137 0267 0457 0327 0517 0647", path, " ")
    for (z = 0; z < n; ++z) for (y = 0; y < n; ++y) for (x = 0; x < n; ++x) for (p = 1; p <= count; ++p) {
      mx = x >= mirrored; my = y >= mirrored; mz = z >= mirrored
      for (c = 1; c <= 4; ++c) {
        k = substr(path[p], c, 1)
        cx = (k + mx) % 2; cy = (int(k / 2) + my) % 2; cz = (int(k / 4) + mz) % 2
        corner[c] = 1 + x + cx + (n + 1) * (y + cy + (n + 1) * (z + cz))
      }
      if ((mx + my + mz) % 2) { swap = corner[2]; corner[2] = corner[3]; corner[3] = swap }
      if (++tets == inverted) { swap = corner[1]; corner[1] = corner[2]; corner[2] = swap }
      print tets, 4, 2, 0, 1, corner[1], corner[2], corner[3], corner[4]
    }
    print "$EndElements"
  }'
}
# The same with each z off by up to $2 m, which is random.
write_rough_mesh() {
  write_mesh "$1" | awk -v noise="$2" 'BEGIN { srand(3) }
    NF == 4 { printf "%d %.17g %.17g %.17g\n", $1, $2, $3, $4 + noise * (2 * rand() - 1); next } { print }'
}
# A cube whose tets all have its middle as a corner, 12 N^2 of them, and a node that none has.
write_star() {
  awk -v m="$1" 'function node(k, s, a, b) {
      p[k] = s; p[(k + 1) % 3] = a; p[(k + 2) % 3] = b
      name = p[0] " " p[1] " " p[2]
      if (!(name in number)) { number[name] = ++nodes; lines = lines nodes " " .08 * p[0] / m " " .08 * p[1] / m " " .08 * p[2] / m "\n" }
      return number[name]
    }
    function tet(a, b, c, turned) { tets = tets (++count) " 4 2 0 1 1 " a " " (turned ? c " " b : b " " c) "\n" }
    BEGIN {
      nodes = 2; lines = "1 .04 .04 .04\n2 1 1 1\n"
      for (k = 0; k < 3; ++k) for (s = 0; s <= m; s += m) for (a = 0; a < m; ++a) for (b = 0; b < m; ++b) {
        n00 = node(k, s, a, b); n10 = node(k, s, a + 1, b); n11 = node(k, s, a + 1, b + 1); n01 = node(k, s, a, b + 1)
        tet(n00, n10, n11, s == 0); tet(n00, n11, n01, s == 0)
      }
      print "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" nodes "\n" lines "$EndNodes\n$Elements\n" count "\n" tets "$EndElements"
    }'
}
small=(--cells 4 --threads 1)
exactly=(--threads 1 --compress 0.05 --precision double --tolerance 1e-10)

case $rule in
  a_mesh_takes_the_place_of_the_cube)
    write_mesh 5 0 2 >m.msh
    expect_exit 0 --mesh m.msh --threads 1 --compress 0.05 --out o
    expect out '750 tets, 216 nodes, 2 levels'
    [[ -s o/cube.vtkhdf && ! -e o/beads.csv ]] || fail 'other files'
    expect_exit 0 --mesh m.msh --threads 1 --compress 0.05 --dry-run
    ((10 * $(sed -nE 's/^solver: ([0-9]+) bytes.*/\1/p' out) - 10 * $(number_of bytes o/run.json) == 0)) || fail 'other bytes'
    # The cube is that mesh: in both, tets give the same equilibrium.
    flags=(--threads 1 --volume tets --compress 0.05 --tolerance 1e-10 --precision double)
    expect_exit 0 --mesh m.msh "${flags[@]}" --out a
    expect_exit 0 --cells 5 "${flags[@]}" --out b
    awk -v a="$(number_of reaction a/run.json)" -v b="$(number_of reaction b/run.json)" \
      'BEGIN { exit !(a < 0 && (a - b) ^ 2 < 1e-14 * a * a) }' || fail 'another reaction' ;;
  a_mesh_by_itself_has_multigrid_over_a_background_grid)
    write_mesh 9 >m.msh
    expect_exit 0 --mesh m.msh --threads 1 --compress 0.05 --out a
    expect out 'note: multigrid over a background grid of 4 x 4 x 4 cells, and load steps on this mesh alone: nested steps need .* --refine'
    expect out '4374 tets, 1000 nodes, 2 levels'
    expect a/run.json 'stepping.*loads'
    expect_exit 0 --mesh m.msh --threads 1 --compress 0.05 --preconditioner block-jacobi --out b
    expect_no out 'note'
    expect out '4374 tets, 1000 nodes, 1 levels'
    ((4 * $(number_of pcg_iterations a/run.json | sed -n 1p) < $(number_of pcg_iterations b/run.json | sed -n 1p))) ||
      fail 'many iterations'
    for flags in "" "--volume tets --precision double" "--refine 1 --precision float"; do
      # shellcheck disable=SC2086
      expect_exit 0 --mesh m.msh --threads 1 --compress 0.01 --out o $flags
      # shellcheck disable=SC2086
      expect_exit 0 --mesh m.msh --threads 1 --compress 0.01 --dry-run $flags
      said=$(sed -nE 's/^solver: ([0-9]+) bytes.*/\1/p' out)
      took=$(number_of bytes o/run.json)
      ((said == took)) || fail "$flags: $said bytes said, $took taken"
    done
    expect_exit 1 --scene quasistatic --mesh m.msh --compress 0.01
    expect err 'needs a background grid, which --scene quasistatic does not have; add --preconditioner block-jacobi, or take --scene everything'
    expect_exit 0 --scene quasistatic --mesh m.msh --threads 1 --compress 0.01 --preconditioner block-jacobi
    expect_exit 0 --scene everything --material stable-neo-hookean --precision float --mesh m.msh --threads 1 --compress 0.01 ;;
  a_refined_mesh_has_multigrid)
    write_mesh 2 >m.msh
    expect_exit 0 --mesh m.msh --refine 2 --threads 1 --compress 0.05
    expect out '3072 tets, 729 nodes, 3 levels'
    expect_no out 'block Jacobi' ;;
  flat_refined_tets_near_a_half_take_few_steps)
    # Cells that narrow to the faces. With fewer steps of power iteration multigrid is not definite there: 16 steps.
    write_mesh 8 0 4 | awk 'function at(x) { return x <= .04 ? .04 * (x / .04) ^ 1.5 : .08 - .04 * ((.08 - x) / .04) ^ 1.5 }
      NF == 4 { printf "%d %.17g %.17g %.17g\n", $1, at($2), at($3), at($4); next } { print }' >m.msh
    expect_exit 0 --mesh m.msh --refine 1 --threads 1 --poisson 0.499 --compress 0.02
    expect out 'solved in .*: [3-6] Newton steps'
    ! grep -q filtered out || fail 'the tangent was made definite' ;;
  a_mesh_that_is_not_sound_is_refused_with_places)
    write_mesh 2 7 >m.msh
    expect_exit 1 --mesh m.msh
    expect err 'm.msh cannot be used'
    expect err 'negative volume [(]element 7[)]'
    write_mesh 2 | sed 's/^48$/40/' >m.msh # a count of fewer elements than there are
    expect_exit 1 --mesh m.msh
    expect err 'm.msh: [$]Elements in line 34 should have 40 lines by its counts, but has 48 before [$]EndElements in line 84'
    expect_exit 1 --mesh absent.msh
    expect err 'absent.msh'
    echo 'no mesh' >text.msh
    expect_exit 1 --mesh text.msh
    expect err 'text.msh' ;;
  tets_in_messages_have_the_numbers_of_their_elements)
    # Elements 1001 ... in another order than that of their numbers.
    write_mesh 3 | awk '/^\$Elements/ { inside = 1 } /^\$EndElements/ { inside = 0; while (n > 0) print line[n--] }
      inside && NF == 9 { $1 += 1000; line[++n] = $0; next } { print }' >m.msh
    flags=(--mesh m.msh --threads 1 --volume tets --material st-venant-kirchhoff)
    expect_exit 0 "${flags[@]}" --compress 0.6
    said=$(sed -nE 's/.*most of all (tet [0-9]+ [(]element [0-9]+) of the mesh file[)]: J -.*/\1/p' err)
    read -r _ tet _ element <<<"$said"
    ((element == tet + 1001)) || fail "not of its element: $said"
    expect_exit 0 "${flags[@]}" --compress 0.3 --refine 1
    said=$(sed -nE 's/.*most of all (tet [0-9]+ [(]part of element [0-9]+) of the mesh file[)]: J -.*/\1/p' err)
    read -r _ tet _ _ _ element <<<"$said"
    ((element == tet / 8 + 1001)) || fail "not a part of its element: $said" ;;
  stars_lone_nodes_and_bodies_of_two_parts_are_solved)
    # 12 * 21^2 = 5292 tets around one node, and a node of no tet.
    write_star 21 >star.msh
    expect_exit 0 --mesh star.msh --threads 1 --compress 0.02
    expect out 'note: 1 nodes of star.msh belong to no tet and are left out'
    expect out '^5292 tets, 2649 nodes'
    expect out 'solved in'
    expect_exit 0 --mesh star.msh --threads 1 --set-up
    expect out '^  reading of the mesh +[0-9.]+ +[0-9.]+ '
    expect out '^  checks of the mesh '
    # Each part is held by the plates, which have the nodes of both.
    write_mesh 2 | awk '{ line[++lines] = $0 } NF == 4 { $1 += 27; $2 += 0.2; node[++nodes] = $0 }
      NF == 9 { $1 += 48; for (c = 6; c <= 9; ++c) $c += 27; tet[++count] = $0 }
      END { for (k = 1; k <= lines; ++k) {
        if (line[k] == "27" || line[k] == "48") print 2 * line[k]; else if (line[k] == "$EndNodes" || line[k] == "$EndElements") {
          for (n = 1; line[k] == "$EndNodes" && n <= nodes; ++n) print node[n]
          for (n = 1; line[k] == "$EndElements" && n <= count; ++n) print tet[n]
          print line[k]
        } else print line[k] } }' >two.msh
    write_mesh 2 >one.msh
    expect_exit 0 --mesh one.msh "${exactly[@]}" --out one
    expect_exit 0 --mesh two.msh "${exactly[@]}" --out two
    expect out 'the mesh has 2 parts that share no node.*48 elements and 27 nodes from element 1 .*, 48 elements and 27 nodes from element 49'
    awk -v one="$(number_of reaction one/run.json)" -v two="$(number_of reaction two/run.json)" \
      'BEGIN { exit !(one < -0.1 && (two - 2 * one) ^ 2 < 1e-12 * one * one) }' || fail 'not twice the reaction' ;;
  a_single_tet_is_no_body_between_plates_and_a_binary_file_that_is_cut_off_is_refused)
    printf '%s\n' '$MeshFormat' '2.2 0 8' '$EndMeshFormat' '$Nodes' 4 '1 0 0 0' '2 1 0 0' '3 0 1 0' '4 0 0 1' '$EndNodes' \
      '$Elements' 1 '1 4 2 0 1 1 2 3 4' '$EndElements' >one.msh
    expect_exit 1 --mesh one.msh
    expect err 'These are only 3 and 1, .*: give the mesh flat faces there, or a larger --plate-tolerance'
    # Held by a face, and pulled at the node opposite, it is a case that can be solved.
    sed -e 's/^\$Nodes/$PhysicalNames\n2\n2 1 "base"\n0 2 "tip"\n$EndPhysicalNames\n&/' \
      -e '/^\$Elements/,$ { s/^1$/3/; s/^\$EndE/2 2 2 1 1 1 2 3\n3 15 2 2 2 4\n&/ }' one.msh >named.msh
    echo '{"mesh": "named.msh", "material": {"young": 6e3, "poisson": 0.45}, "supports": [{"group": "base"}],
      "loads": [{"group": "tip", "force": [1, 0, -20]}]}' >one.json
    for volume in tets patches nodes; do
      expect_exit 0 --case one.json --threads 1 --volume $volume --precision double --tolerance 1e-10 --out $volume
      expect out '^1 tets, 4 nodes, 1 levels'
      expect out 'reaction of base: [(]-1, [-0-9.e]+, 20[)] N'
      awk -v a="$(number_of energy $volume/run.json | sed -n 1p)" -v b="$(number_of energy tets/run.json | sed -n 1p)" \
        'BEGIN { exit !(a < -0.05 && (a - b) ^ 2 < 1e-20) }' || fail "another energy by $volume"
    done
    for bytes in 60 1000 5000; do
      head -c $bytes "$here/../../fem/mesh/gmsh/binary_41.msh" >cut.msh
      expect_exit 1 --mesh cut.msh --out o
      expect err 'cut.msh.*the file may be cut off or damaged: write it again'
      [[ ! -e o ]] || fail 'a folder was made'
    done ;;
  memory_that_ends_in_the_set_up_of_a_mesh_is_said_with_its_stage_and_bytes)
    write_mesh 20 >m.msh
    # From the addresses that the program needs for itself to those that all of the set-up has room in.
    limited() { # kilobytes arguments...
      got=0
      (ulimit -v "$1" && "$program" "${@:2}" >out 2>err) || got=$?
    }
    bare=16000
    for ((got = 1; got != 0; bare += 4000)); do limited $bare --cells 2 --threads 1 --dry-run; done
    got=1 stages=''
    for ((limit = bare; got != 0; limit += 4000)); do
      rm -rf o
      limited $limit --mesh m.msh --threads 1 --set-up --quiet --out o
      ((got == 0)) && break
      ((got == 1)) || fail "exit $got within $limit kB"
      expect err '^truthcube: (the memory ended in its stage "[a-z ]+": .*[0-9]+ .*bytes|.* takes [0-9.]+ GB .*, and this machine has )'
      [[ ! -e o || -z $(ls -A o) ]] || fail "left within $limit kB: $(ls -A o)"
      stages+=$(sed -nE 's/.*in its stage "([a-z ]+)".*/ (\1)/p' err)
    done
    [[ $stages == *'(arrays of levels)'*'(arrays of meshes)'* ]] || fail "ended in$stages"
    limited $limit --mesh m.msh --threads 1 --set-up
    ((got == 0)) || fail "exit $got without room for a copy"
    expect out 'no room for a copy beside the solver, so its rate was not measured$' ;;
  ctrl_c_ends_the_set_up_of_a_mesh_and_leaves_nothing)
    write_mesh 40 >m.msh
    for seconds in 0.05 0.15; do
      got=0
      timeout -k 1 -s INT $seconds "$program" --mesh m.msh --threads 1 --set-up --out o >out 2>err || got=$?
      ((got == 124)) || fail "exit $got" # 137 where it had to be killed
      [[ ! -e o || -z $(ls -A o) || $(ls -A o) == run.lock ]] || fail "left: $(ls -A o)"
    done
    expect_exit 0 --mesh m.msh --threads 1 --set-up --out o ;;
  a_mesh_that_is_too_large_when_refined_is_refused_before_it_is_made)
    write_mesh 8 >m.msh
    expect_exit 1 --mesh m.msh --refine 6
    expect err 'the mesh refined [3-6] times (takes [0-9.]+ GB|has [0-9]+ nodes .* more than 32-bit).*; --refine [2-5] takes' ;;
  faces_that_are_flat_but_for_rounding_are_held_as_flat_ones_are)
    write_mesh 4 >flat.msh
    for flags in "--stepping loads" "--refine 1" "--scene linear-elastic" "--top frictionless --plates contact"; do
      # shellcheck disable=SC2086
      expect_exit 0 --mesh flat.msh "${exactly[@]}" $flags --out flat
      held=$(grep '^plates hold' out)
      for noise in 1e-9 3e-9 8e-11 8e-10 8e-9 2.4e-10; do # [m]: also 1e-9 .. 1e-7 and 3e-9 of the height
        write_rough_mesh 4 $noise >rough.msh
        # shellcheck disable=SC2086
        expect_exit 0 --mesh rough.msh "${exactly[@]}" $flags --out rough
        [[ $(grep '^plates hold' out) == "$held" ]] || fail "$flags, $noise: not $held"
        expect_no err 'just beyond'
        awk -v a="$(number_of reaction flat/run.json)" -v b="$(number_of reaction rough/run.json)" \
          'BEGIN { exit !(a < -0.1 && (a - b) ^ 2 < 1e-12 * a * a) }' || fail "$flags, $noise: another reaction"
      done
    done
    expect_exit 0 --mesh flat.msh --threads 1 --compress 0.05
    expect out '^plates hold 25 and 25 nodes, 6400 and 6400 mm.2 of the surface [(]lower and upper[)]$'
    for noise in 1e-8 1e-7; do # where the body itself is another by 1e-6
      write_rough_mesh 4 $noise >rough.msh
      expect_exit 0 --mesh rough.msh --threads 1 --compress 0.05
      expect out '^plates hold 25 and 25 nodes, 6400 and 6400 mm'
    done ;;
  nodes_just_beyond_a_plate_are_said_and_can_be_held)
    # Four of the upper nodes, at a corner, 4 um below the others, where a mean edge is 24.8 mm.
    write_mesh 4 | awk 'NF == 4 && $2 > .05 && $3 > .05 && $4 == .08 { $4 = .079996 } { print }' >step.msh
    expect_exit 0 --mesh step.msh --threads 1 --compress 0.05 --quiet --out o
    expect err 'warning: the upper plate holds the 21 nodes within 0.00[0-9]+ mm of its plane; 4 more .* just beyond, up to 0.004 mm from it'
    remedy=$(sed -nE 's/.*(--plate-tolerance [0-9.e-]+)$/\1/p' err)
    expect o/run.json '"plate_tolerance": 0.0001'
    tr -d ' \n' <o/run.json | grep -qE '"held":[{]"lower":[{]"nodes":25,"area":0.00(64|63999)' || fail 'lower plate in run.json'
    tr -d ' \n' <o/run.json | grep -qE '"upper":[{]"nodes":21,"area":0.00(48|47999)' || fail 'upper plate in run.json'
    # shellcheck disable=SC2086
    expect_exit 1 --mesh step.msh --threads 1 --compress 0.1 --out o --restart $remedy
    expect err 'plate_tolerance'
    expect_exit 0 --mesh step.msh --threads 1 --compress 0.05 0.06 --out o --restart --plate-tolerance 0.0001
    # shellcheck disable=SC2086
    expect_exit 0 --mesh step.msh --threads 1 --compress 0.05 $remedy
    expect out '^plates hold 25 and 25 nodes'
    [[ ! -s err ]] || fail 'a warning'
    expect_exit 0 --mesh step.msh --dry-run
    expect out '^plates hold 25 and 21 nodes' ;;
  faces_that_are_too_rough_are_refused_with_what_lies_just_beyond)
    write_rough_mesh 4 1e-5 >rough.msh
    expect_exit 1 --mesh rough.msh --plate-tolerance 0
    expect err 'only 1 and 1, with 24 and 24 more just beyond: .* a larger --plate-tolerance' ;;
  *) fail 'no such rule' ;;
esac
