/* An arm of hinges about their z axes for Pinocchio, and laws of its angles, as `pinocchio_peers.py` writes them. */
#include <iostream>
#include <string>
#include <vector>

#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/kinematics.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/multibody.hpp>

struct Arm {
    pinocchio::Model model;
    std::vector<Eigen::Vector3d> centers;
    /* Offset, amplitude, frequency in rad/s and phase. */
    std::vector<Eigen::Vector4d> laws;

    explicit Arm(std::istream &in) {
        int count;
        in >> count;
        auto next = [&in] {
            double value;
            in >> value;
            return value;
        };
        model.gravity.linear() = Eigen::Vector3d(0, 0, -9.81);
        for (int k = 0; k < count; k++) {
            Eigen::Matrix3d turned, inertia = Eigen::Matrix3d::Zero();
            Eigen::Vector3d place, center;
            Eigen::Vector4d law;
            for (double &entry : place) entry = next();
            for (int i = 0; i < 9; i++) turned(i / 3, i % 3) = next();
            double mass = next();
            for (double &entry : center) entry = next();
            for (int i = 0; i < 3; i++) inertia(i, i) = next();
            for (double &entry : law) entry = next();
            auto joint = model.addJoint(k, pinocchio::JointModelRZ(), pinocchio::SE3(turned, place), "joint " + std::to_string(k));
            model.appendBodyToJoint(joint, pinocchio::Inertia(mass, center, inertia), pinocchio::SE3::Identity());
            centers.push_back(center);
            laws.push_back(law);
        }
    }

    /* Of every body, after `forwardKinematics` with accelerations: matrix by rows, then of the mass centre place, velocity, angular velocity,
       acceleration and angular acceleration. */
    template <class Data, class Put> void bodies(const Data &data, Put put) const {
        for (size_t k = 0; k < centers.size(); k++) {
            typedef typename Data::Scalar Scalar;
            typedef Eigen::Matrix<Scalar, 3, 1> Vector;
            const auto &placement = data.oMi[k + 1];
            const auto &rotation = placement.rotation();
            const Vector center = centers[k].cast<Scalar>(), w = data.v[k + 1].angular(), v = data.v[k + 1].linear();
            const Vector turning = data.a[k + 1].angular(), swing = w.cross(center), rate = v + swing;
            const Vector change = data.a[k + 1].linear() + turning.cross(center) + w.cross(rate);
            const Vector vectors[5] = {
                rotation * center + placement.translation(), rotation * rate, rotation * w, rotation * change, rotation * turning};
            for (int i = 0; i < 9; i++) put(24 * k + i, rotation(i / 3, i % 3));
            for (int i = 0; i < 15; i++) put(24 * k + 9 + i, vectors[i / 3](i % 3));
        }
    }
};
