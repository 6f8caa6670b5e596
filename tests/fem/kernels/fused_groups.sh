#!/usr/bin/env bash
# Whether each fused group is one CUDA kernel without a stack frame and without spilled registers: its locals are then
# in registers. Prints the registers of each; fails, naming the groups, where one needs local memory. And with too few
# registers for them, groups that spill must be named.
#   fused_groups.sh NVCC ARCHITECTURE SOURCE WORK_FOLDER FLAGS...
set -euo pipefail
compiler=$1 architecture=$2 source=$3 work=$4
shift 4
mkdir -p "$work"
"$compiler" "$@" "-arch=$architecture" -ptx -o "$work/fused_groups.ptx" "$source" 2>"$work/nvcc.txt" ||
  { grep error "$work/nvcc.txt"; exit 1; }
# Of every group that ptxas makes with these options: its registers, or what it needs beside them.
groups() {
  "$(dirname "$(command -v "$compiler")")/ptxas" "-arch=$architecture" -v "$@" -o "$work/fused_groups.cubin" "$work/fused_groups.ptx" \
    2>"$work/ptxas.txt" || { cat "$work/ptxas.txt"; exit 1; }
  awk '/Compiling entry function/ {split($0, part, "\047"); group = part[2]; ++groups}
     /bytes stack frame/ && group {
       frame = $1 + 0; spilled = 0
       for (k = 2; k <= NF; ++k) if ($k == "spill") spilled += $(k - 2)
       if (frame || spilled) {
         printf "FAILED: the fused group %s has a stack frame of %d bytes and spills %d: its locals are no registers\n", group, frame, spilled
         failed = 1
       }
     }
     /Used [0-9]+ registers/ && group {
       for (k = 1; k < NF; ++k) if ($k == "Used") printf "%-45s %3d registers\n", group, $(k + 1)
       ++counted
     }
     END {
       if (groups < 1 || counted != groups) {print "FAILED: ptxas told of " counted + 0 " groups of " groups + 0; failed = 1}
       exit failed
     }' "$work/ptxas.txt"
}
groups
if said=$(groups -maxrregcount=40); then
  echo "FAILED: with 40 registers no group is said to spill:"
  echo "$said"
  exit 1
fi
grep -qE 'the fused group newton_update_in_double has a stack frame of [1-9][0-9]* bytes and spills [1-9]' <<<"$said" ||
  { echo "FAILED: with 40 registers newton_update_in_double is not said to spill:"; echo "$said"; exit 1; }
