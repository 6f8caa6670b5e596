// A kernel that needs local memory: its array is indexed at run time. It must not compile with the kernels' options.
__global__ void histogram(int* values, int count) {
  int bins[32] = {};
  for (int i = 0; i < count; ++i) ++bins[values[i] & 31];
  for (int i = 0; i < 32; ++i) values[i] = bins[i];
}
