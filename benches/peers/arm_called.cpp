/* Pinocchio's own algorithms, called from C++. */
#include <chrono>
#include <sstream>

#include "arm.hpp"

static Arm *arm;
static pinocchio::Data *data;

extern "C" void load(const char *described) {
    std::istringstream in(described);
    arm = new Arm(in);
    data = new pinocchio::Data(arm->model);
}

static double since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count();
}

/* What all bodies do at each time; `seen`, if there is one, is told all of it. Returns ns per step. */
extern "C" double sweep(const double *times, int steps, double *seen) {
    const int n = arm->model.nv;
    Eigen::VectorXd q(n), v(n), a(n);
    std::vector<double> bodies(24 * n);
    const auto begin = std::chrono::steady_clock::now();
    for (int step = 0; step < steps; step++) {
        for (int k = 0; k < n; k++) {
            const Eigen::Vector4d &law = arm->laws[k];
            const double angle = law[2] * times[step] + law[3], sine = std::sin(angle), cosine = std::cos(angle);
            q[k] = law[0] + law[1] * sine, v[k] = law[1] * law[2] * cosine, a[k] = -law[1] * law[2] * law[2] * sine;
        }
        pinocchio::forwardKinematics(arm->model, *data, q, v, a);
        arm->bodies(*data, [&](int place, double value) { bodies[place] = value; });
        asm volatile("" : : "r"(bodies.data()) : "memory");
        if (seen) std::copy(bodies.begin(), bodies.end(), seen + step * bodies.size());
    }
    return since(begin) / steps;
}

/* Torques of states with accelerations, or accelerations of states, one after the other. Returns ns for each. */
extern "C" double evaluate(int is_inverse, const double *states, int all, int count, double *seen) {
    const int n = arm->model.nv, size = is_inverse ? 3 * n : 2 * n;
    Eigen::VectorXd q(n), v(n), a(n), none = Eigen::VectorXd::Zero(n);
    const auto begin = std::chrono::steady_clock::now();
    for (int k = 0; k < count; k++) {
        const double *state = states + size * (k % all);
        q = Eigen::Map<const Eigen::VectorXd>(state, n), v = Eigen::Map<const Eigen::VectorXd>(state + n, n);
        if (is_inverse) a = Eigen::Map<const Eigen::VectorXd>(state + 2 * n, n);
        const auto &found = is_inverse ? pinocchio::rnea(arm->model, *data, q, v, a) : pinocchio::aba(arm->model, *data, q, v, none);
        asm volatile("" : : "r"(found.data()) : "memory");
        if (seen) std::copy(found.data(), found.data() + n, seen + k * n);
    }
    return since(begin) / count;
}
