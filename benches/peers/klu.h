/* What is used of KLU 1.3, whose wheel brings the library without its header. Names, order and types of the members of
   klu_common are those of that version. */
#include <stddef.h>

typedef struct {
    double tol, memgrow, initmem_amd, initmem, maxwork;
    int btf, ordering, scale;
    void *(*malloc_memory)(size_t);
    void *(*realloc_memory)(void *, size_t);
    void (*free_memory)(void *);
    void *(*calloc_memory)(size_t, size_t);
    int (*user_order)(int, int *, int *, int *, void *);
    void *user_data;
    int halt_if_singular, status, nrealloc, structural_rank, numerical_rank, singular_col, noffdiag;
    double flops, rcond, condest, rgrowth, work;
    size_t memusage, mempeak;
} klu_common;

int klu_defaults(klu_common *);
void *klu_analyze(int n, int *columns, int *rows, klu_common *);
void *klu_factor(int *columns, int *rows, double *values, void *symbolic, klu_common *);
int klu_refactor(int *columns, int *rows, double *values, void *symbolic, void *numeric, klu_common *);
int klu_solve(void *symbolic, void *numeric, int rows, int right_sides, double *b, klu_common *);
