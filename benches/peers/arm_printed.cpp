/* Pinocchio's templates with CasADi's expressions for numbers, printed as C. In: an arm on standard input. Out: `tree.c` and `answers.c` in the
   current folder, and on standard output the sizes of work arrays. */
#include <casadi/casadi.hpp>
#include <pinocchio/autodiff/casadi.hpp>

#include "arm.hpp"

using casadi::SX;
typedef Eigen::Matrix<SX, Eigen::Dynamic, 1> Vector;

static Vector entries(const SX &of) {
    Vector made(of.numel());
    for (int k = 0; k < made.size(); k++) made[k] = of(k);
    return made;
}

static SX column(const Vector &of) {
    SX made(of.size(), 1);
    for (int k = 0; k < of.size(); k++) made(k) = of[k];
    return made;
}

static void print(const std::string &name, const std::vector<casadi::Function> &functions) {
    casadi::CodeGenerator code(name);
    for (const casadi::Function &function : functions) {
        code.add(function);
        std::cout << function.sz_arg() << " " << function.sz_res() << " " << function.sz_iw() << " " << function.sz_w() << "\n";
    }
    code.generate();
}

int main() {
    const Arm arm(std::cin);
    const auto model = arm.model.cast<SX>();
    pinocchio::DataTpl<SX> data(model);
    const int n = arm.model.nv;

    SX t = SX::sym("t"), bodies = SX::zeros(24 * n, 1);
    Vector q(n), v(n), a(n);
    for (int k = 0; k < n; k++) {
        const Eigen::Vector4d &law = arm.laws[k];
        const SX angle = law[2] * t + law[3], sine = sin(angle), cosine = cos(angle);
        q[k] = law[0] + law[1] * sine, v[k] = law[1] * law[2] * cosine, a[k] = -law[1] * law[2] * law[2] * sine;
    }
    pinocchio::forwardKinematics(model, data, q, v, a);
    arm.bodies(data, [&](int place, const SX &value) { bodies(place) = value; });
    print("tree.c", {casadi::Function("tree", {t}, {bodies})});

    const SX state = SX::sym("state", 2 * n), motion = SX::sym("motion", 3 * n);
    const casadi::Slice of_q(0, n), of_v(n, 2 * n), of_a(2 * n, 3 * n);
    const SX torques = column(pinocchio::rnea(model, data, entries(motion(of_q)), entries(motion(of_v)), entries(motion(of_a))));
    const Vector none = entries(SX::zeros(n, 1));
    const SX found = column(pinocchio::aba(model, data, entries(state(of_q)), entries(state(of_v)), none, pinocchio::Convention::LOCAL));
    print("answers.c", {casadi::Function("torques", {motion}, {torques}), casadi::Function("accelerations", {state}, {found})});
}
