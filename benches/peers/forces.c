/* What follows from forces, in C. `mechanism.h` is generated; it says INPUTS and OUTPUTS of the function `answer`, which has no state, and,
   where there is a motion to follow, HAS_MOTION: `derive` gives the derivatives of SIZE numbers. */
#include <math.h>
#include <string.h>
#include <time.h>

#include "mechanism.h"
#include "sundials.h"

typedef long long casadi_int;
typedef int function(const double **, double **, casadi_int *, double *, int);

static double w[CASADI_W];
static casadi_int iw[CASADI_IW];
static const double *arguments[CASADI_ARG];
static double *results[CASADI_RES];

static double since(struct timespec begin) {
    struct timespec end;
    clock_gettime(CLOCK_MONOTONIC, &end);
    return (end.tv_sec - begin.tv_sec) * 1e9 + (end.tv_nsec - begin.tv_nsec);
}

#ifdef OUTPUTS
/* One after the other in all states, `count` in all; `seen`, if there is one, is told the answers. Returns ns for each. */
double evaluate(function *answer, const double *states, int all, int count, double *seen) {
    static double found[OUTPUTS];
    struct timespec begin;
    clock_gettime(CLOCK_MONOTONIC, &begin);
    for (int k = 0; k < count; k++) {
        arguments[0] = states + INPUTS * (k % all), results[0] = found;
        answer(arguments, results, iw, w, 0);
        // The memory is observed after each.
        __asm__ volatile("" : : "r"(found) : "memory");
        if (seen) memcpy(seen + OUTPUTS * k, found, sizeof found);
    }
    return since(begin) / count;
}
#endif

#ifdef HAS_MOTION
function derive;

static void derivatives(const double *y, double *rates) {
    arguments[0] = y, results[0] = rates;
    derive(arguments, results, iw, w, 0);
}

static int for_cvode(double t, N_Vector y, N_Vector rates, void *data) {
    derivatives(N_VGetArrayPointer(y), N_VGetArrayPointer(rates));
    return 0;
}

static void for_dop853(double t, double *y, double *rates, double *data) { derivatives(y, rates); }

/* The interface in C of a Fortran module in the wheel of numbalsoda. */
typedef void rates(double t, double *y, double *rates, double *data);
void dop853_wrapper(rates *, int size, double *start, double *data, int count, double *times, double *found, double relative, double absolute,
                    int steps, int *success);

static int by_cvode(int is_adams, double duration, double tolerance, double *y) {
    static SUNContext context;
    if (!context) SUNContext_Create(0, &context);
    N_Vector vector = N_VMake_Serial(SIZE, y, context);
    void *solver = CVodeCreate(is_adams ? CV_ADAMS : CV_BDF, context);
    CVodeInit(solver, for_cvode, 0, vector);
    CVodeSStolerances(solver, tolerance, tolerance);
    CVodeSetMaxNumSteps(solver, 10000000);
    CVodeSetStopTime(solver, duration);
    SUNNonlinearSolver fixed = 0;
    SUNMatrix matrix = 0;
    SUNLinearSolver linear = 0;
    if (is_adams) {
        fixed = SUNNonlinSol_FixedPoint(vector, 0, context);
        CVodeSetNonlinearSolver(solver, fixed);
    } else {
        matrix = SUNDenseMatrix(SIZE, SIZE, context);
        linear = SUNLinSol_Dense(vector, matrix, context);
        CVodeSetLinearSolver(solver, linear, matrix);
    }
    double reached;
    int flag = CVode(solver, duration, vector, &reached, CV_NORMAL);
    CVodeFree(&solver);
    if (fixed) SUNNonlinSolFree(fixed);
    if (linear) SUNLinSolFree(linear), SUNMatDestroy(matrix);
    N_VDestroy(vector);
    return flag >= 0;
}

static int by_dop853(double duration, double tolerance, double *y) {
    double times[2] = {0, duration}, found[2 * SIZE], nothing = 0;
    int success = 0;
    dop853_wrapper(for_dop853, SIZE, y, &nothing, 2, times, found, tolerance, tolerance, 10000000, &success);
    memcpy(y, found + SIZE, SIZE * sizeof(double));
    return success == 1;
}

/* From the beginning to `duration` by method 0 CVODE's Adams formulas, 1 its BDF, 2 DOP853, with the tolerance as a relative and as an
   absolute one; `y` begins with the start and ends with the end. Returns ns, or -1 if it did not get there. */
double follow(int method, double duration, double tolerance, double *y) {
    struct timespec begin;
    clock_gettime(CLOCK_MONOTONIC, &begin);
    int is_there = method == 2 ? by_dop853(duration, tolerance, y) : by_cvode(method == 0, duration, tolerance, y);
    double time = since(begin);
    return is_there ? time : -1;
}
#endif
