// particles_on_cuda: the same program, whose particles lie in the memory of a GPU and whose kernels run there.
#include "main.cpp"
