/* Ways to follow a mechanism in space, in C: straight lines that CasADi printed with Newton's method around them, CasADi's own Newton's
   method, and what Pinocchio's templates gave. `mechanism.h` is generated; it says UNKNOWNS, BODIES, GIVEN (samples of a step) and start[],
   and HAS_WHOLE or HAS_TREE. */
#include <math.h>
#include <string.h>
#include <time.h>

#include "mechanism.h"

typedef long long casadi_int;
typedef int function(const double **, double **, casadi_int *, double *, int);

function correction, state, whole, tree;

static double u[UNKNOWNS + 1], ud[UNKNOWNS + 1], udd[UNKNOWNS + 1], bodies[24 * BODIES], last;
static double w[CASADI_W];
static casadi_int iw[CASADI_IW];
static const double *arguments[CASADI_ARG];
static double *results[CASADI_RES];

static void predict(double t) {
    double h = t - last;
    for (int i = 0; i < UNKNOWNS; i++) u[i] += h * (ud[i] + 0.5 * h * udd[i]);
    last = t;
}

static void call(function *called, const double *t, const double *given) {
    arguments[0] = u, arguments[1] = t, arguments[2] = given;
    called(arguments, results, iw, w, 0);
}

/* Newton's method until a correction is not larger than the tolerance. */
static void by_corrections(double t, const double *given, double tolerance) {
    double change[UNKNOWNS + 1], largest = INFINITY;
    predict(t);
    while (UNKNOWNS && largest > tolerance) {
        results[0] = change;
        call(correction, &t, given);
        largest = 0;
        for (int i = 0; i < UNKNOWNS; i++) {
            u[i] += change[i];
            largest = fmax(largest, fabs(change[i]));
        }
    }
    results[0] = ud, results[1] = udd, results[2] = bodies;
    call(state, &t, given);
}

#ifdef HAS_WHOLE
static void by_casadi(double t, const double *given) {
    predict(t);
    results[0] = u, results[1] = ud, results[2] = udd, results[3] = bodies;
    call(whole, &t, given);
}
#endif

#ifdef HAS_TREE
static void by_tree(double t) {
    arguments[0] = &t, results[0] = bodies;
    tree(arguments, results, iw, w, 0);
}
#endif

static void step(int method, double tolerance, double t, const double *given) {
#ifdef HAS_WHOLE
    if (method == 1) {
        by_casadi(t, given);
        return;
    }
#endif
#ifdef HAS_TREE
    if (method == 2) {
        by_tree(t);
        return;
    }
#endif
    by_corrections(t, given, tolerance);
}

/* Follows the mechanism by method 0 corrections, 1 CasADi's Newton's method, 2 the printed tree; `given` has the samples of all steps and of
   the one at t = 0 before them. `seen`, if there is one, is told what all bodies do at each time. Returns ns per step. */
double sweep(int method, double tolerance, const double *times, const double *given, int steps, double *seen) {
    memcpy(u, start, sizeof(double) * UNKNOWNS), memset(ud, 0, sizeof ud), memset(udd, 0, sizeof udd), last = 0;
    by_corrections(0, given, 1e-9);
    struct timespec begin, end;
    clock_gettime(CLOCK_MONOTONIC, &begin);
    for (int k = 0; k < steps; k++) {
        given += GIVEN;
        step(method, tolerance, times[k], given);
        // The memory is observed after each step.
        __asm__ volatile("" : : "r"(bodies) : "memory");
        if (seen) memcpy(seen + 24 * BODIES * k, bodies, sizeof bodies);
    }
    clock_gettime(CLOCK_MONOTONIC, &end);
    return ((end.tv_sec - begin.tv_sec) * 1e9 + (end.tv_nsec - begin.tv_nsec)) / steps;
}
