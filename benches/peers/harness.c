/* Four ways to follow a linkage, in C: `closed` by dyads, Newton's method in absolute coordinates with a dense LU or with KLU, both
   on the equations that SymPy printed, and CasADi's generated code. `equations.h` is generated for one linkage; it says N, ENTRIES,
   columns[], rows[] (Jacobian by columns), start[], phi(), nu(), gamma_(), track(), and closed() where HAS_CLOSED, DENSE where a
   dense LU is wanted. */
#include <math.h>
#include <string.h>
#include <time.h>

typedef struct { double x, y, vx, vy, ax, ay; } point;

static point fixed(double x, double y) { return (point){x, y, 0, 0, 0, 0}; }

static point crank(double x, double y, double length, double angle, double rate, double acceleration) {
    double c = length * cos(angle), s = length * sin(angle), square = rate * rate;
    return (point){x + c, y + s, -s * rate, c * rate, -s * acceleration - c * square, c * acceleration - s * square};
}

/* The point at distance ra from a and rb from b, to the left of the way from a to b if side is 1. */
static inline point dyad(point a, double ra, point b, double rb, double side) {
    double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    double along = 0.5 + (ra * ra - rb * rb) / (2 * square), across = side * sqrt(ra * ra / square - along * along);
    point p = {a.x + dx * along - dy * across, a.y + dy * along + dx * across, 0, 0, 0, 0};
    double ux = p.x - a.x, uy = p.y - a.y, wx = p.x - b.x, wy = p.y - b.y, share = 1 / (ux * wy - uy * wx);
    double r = ux * a.vx + uy * a.vy, s = wx * b.vx + wy * b.vy;
    p.vx = (r * wy - uy * s) * share, p.vy = (ux * s - r * wx) * share;
    double ex = p.vx - a.vx, ey = p.vy - a.vy, fx = p.vx - b.vx, fy = p.vy - b.vy;
    r = ux * a.ax + uy * a.ay - ex * ex - ey * ey, s = wx * b.ax + wy * b.ay - fx * fx - fy * fy;
    p.ax = (r * wy - uy * s) * share, p.ay = (ux * s - r * wx) * share;
    return p;
}

/* The slider on y = 0 at the end of a rod. */
static inline point slide(point a, double rod) {
    double root = sqrt(rod * rod - a.y * a.y), rate = -a.y * a.vy / root;
    double second = -(a.vy * a.vy + a.y * a.ay + rate * rate) / root;
    return (point){a.x + root, 0, a.vx + rate, 0, a.ax + second, 0};
}

#include "equations.h"
#include "klu.h"

typedef long long casadi_int;

int linkage_step(const double **, double **, casadi_int *, double *, int);

static double q[N], qd[N], qdd[N], last;
static double predicted[N], phi_[N], values[ENTRIES];

static void predict(double t) {
    double h = t - last;
    for (int i = 0; i < N; i++) predicted[i] = q[i] + h * (qd[i] + 0.5 * h * qdd[i]);
}

static double largest(const double *of) {
    double largest = 0;
    for (int i = 0; i < N; i++) largest = fmax(largest, fabs(of[i]));
    return largest;
}

/* Newton's method to max|phi| <= 1e-12 with whatever factors and solves. */
#define NEWTON(factor, solve)                                                                                                              \
    predict(t);                                                                                                                            \
    for (;;) {                                                                                                                             \
        phi(predicted, t, phi_, values);                                                                                                   \
        factor();                                                                                                                          \
        if (largest(phi_) <= 1e-12) break;                                                                                                 \
        solve(phi_);                                                                                                                       \
        for (int i = 0; i < N; i++) predicted[i] -= phi_[i];                                                                               \
    }                                                                                                                                      \
    memcpy(q, predicted, sizeof q), last = t;                                                                                              \
    nu(q, t, qd), solve(qd);                                                                                                               \
    gamma_(q, qd, t, qdd), solve(qdd)

#ifdef DENSE
static double lu[N][N];
static int pivots[N];

static void dense_factor(void) {
    memset(lu, 0, sizeof lu);
    for (int j = 0; j < N; j++)
        for (int k = columns[j]; k < columns[j + 1]; k++) lu[rows[k]][j] = values[k];
    for (int k = 0; k < N; k++) {
        int pivot = k;
        for (int i = k + 1; i < N; i++)
            if (fabs(lu[i][k]) > fabs(lu[pivot][k])) pivot = i;
        pivots[k] = pivot;
        if (pivot != k)
            for (int j = 0; j < N; j++) {
                double entry = lu[k][j];
                lu[k][j] = lu[pivot][j], lu[pivot][j] = entry;
            }
        double share = 1 / lu[k][k];
        for (int i = k + 1; i < N; i++) {
            if (lu[i][k] == 0) continue;
            double factor = lu[i][k] *= share;
            for (int j = k + 1; j < N; j++) lu[i][j] -= factor * lu[k][j];
        }
    }
}

static void dense_solve(double *b) {
    for (int k = 0; k < N; k++) {
        double entry = b[k];
        b[k] = b[pivots[k]], b[pivots[k]] = entry;
    }
    for (int i = 0; i < N; i++)
        for (int j = 0; j < i; j++) b[i] -= lu[i][j] * b[j];
    for (int i = N - 1; i >= 0; i--) {
        for (int j = i + 1; j < N; j++) b[i] -= lu[i][j] * b[j];
        b[i] /= lu[i][i];
    }
}

static void dense_step(double t) { NEWTON(dense_factor, dense_solve); }
#endif

static klu_common common;
static void *symbolic, *numeric;

/* The pivots of the first factorisation serve all others. */
static void sparse_factor(void) {
    if (!symbolic) {
        klu_defaults(&common);
        symbolic = klu_analyze(N, columns, rows, &common);
        numeric = klu_factor(columns, rows, values, symbolic, &common);
    } else {
        klu_refactor(columns, rows, values, symbolic, numeric, &common);
    }
}

static void sparse_solve(double *b) { klu_solve(symbolic, numeric, N, 1, b, &common); }

static void sparse_step(double t) { NEWTON(sparse_factor, sparse_solve); }

static void casadi_from(const double *guess, double t) {
    static double w[CASADI_W];
    static casadi_int iw[CASADI_IW];
    static const double *arguments[CASADI_ARG];
    static double *results[CASADI_RES];
    arguments[0] = guess, arguments[1] = &t;
    results[0] = q, results[1] = qd, results[2] = qdd;
    linkage_step(arguments, results, iw, w, 0);
    last = t;
}

static void casadi_step(double t) {
    predict(t);
    casadi_from(predicted, t);
}

/* From the position before. */
static void casadi_plain_step(double t) {
    memcpy(predicted, q, sizeof q);
    casadi_from(predicted, t);
}

/* Follows the linkage by method 0 closed, 1 dense, 2 KLU, 3 or 4 CasADi with or without predictor; `seen`, if given, is told x, y and their second derivatives
   at each time. Returns ns per step, or -1 where there is no such method. */
double sweep(int method, const double *times, int steps, double *seen) {
    void (*step_by)(double) = method == 2 ? sparse_step : method == 3 ? casadi_step : casadi_plain_step;
#ifdef DENSE
    if (method == 1) step_by = dense_step;
#else
    if (method == 1) return -1;
#endif
#ifndef HAS_CLOSED
    if (method == 0) return -1;
#endif
    memcpy(q, start, sizeof q), memset(qd, 0, sizeof qd), memset(qdd, 0, sizeof qdd), last = 0;
    if (method) step_by(0);
    struct timespec begin, end;
    volatile double sink;
    clock_gettime(CLOCK_MONOTONIC, &begin);
    for (int k = 0; k < steps; k++) {
        double at[4];
#ifdef HAS_CLOSED
        if (method == 0) {
            point p = closed(times[k]);
            at[0] = p.x, at[1] = p.y, at[2] = p.ax, at[3] = p.ay;
        } else
#endif
        {
            step_by(times[k]);
            if (seen) track(q, qd, qdd, at);
            else at[0] = q[0], at[2] = qdd[0], at[1] = at[3] = 0;
        }
        if (seen) memcpy(seen + 4 * k, at, sizeof at);
        sink = at[0] + at[1] + at[2] + at[3];
    }
    clock_gettime(CLOCK_MONOTONIC, &end);
    (void)sink;
    return ((end.tv_sec - begin.tv_sec) * 1e9 + (end.tv_nsec - begin.tv_nsec)) / steps;
}
