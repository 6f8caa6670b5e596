#!/usr/bin/env bash
# Whether each fused group is one CUDA kernel without a stack frame and without spilled registers: its locals are then
# in registers. Prints the registers of each; fails, naming the groups, where one needs local memory.
#   fused_groups.sh NVCC SOURCE WORK_FOLDER FLAGS...
set -euo pipefail
compiler=$1 source=$2 work=$3
shift 3
mkdir -p "$work"
"$compiler" "$@" -cubin -Xptxas -v -o "$work/fused_groups.cubin" "$source" 2>"$work/ptxas.txt" ||
  { grep error "$work/ptxas.txt"; exit 1; }
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
