// Pinocchio's recursive Newton-Euler and articulated-body algorithms on a serial arm, state by state.
#include <pinocchio/multibody.hpp>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/rnea.hpp>

#include <string>

namespace pin = pinocchio;
using Vector = Eigen::VectorXd;

struct Arm {
    pin::Model model;
    pin::Data data;
};

// A row a joint that turns about z: turn before it, row by row, offset, mass, mass centre, inertia.
extern "C" void *arm_new(int joints, double g, const double *rows)
{
    pin::Model model;
    model.gravity.linear(Eigen::Vector3d(0, 0, -g));
    pin::JointIndex joint = 0;
    for (int i = 0; i < joints; ++i) {
        const double *row = rows + 22 * i;
        const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> turn(row);
        const pin::SE3 at(turn, Eigen::Vector3d(row[9], row[10], row[11]));
        joint = model.addJoint(joint, pin::JointModelRZ(), at, "joint" + std::to_string(i));
        Eigen::Matrix3d moments;
        row += 12;
        moments << row[4], row[7], row[9], row[7], row[5], row[8], row[9], row[8], row[6];
        const pin::Inertia body(row[0], Eigen::Vector3d(row[1], row[2], row[3]), moments);
        model.appendBodyToJoint(joint, body, pin::SE3::Identity());
    }
    return new Arm{model, pin::Data(model)};
}

extern "C" void rnea(void *arm, long count, const double *q, const double *u, const double *given,
    double *found)
{
    Arm &a = *static_cast<Arm *>(arm);
    const long n = a.model.nv;
    for (long i = 0; i < count; ++i) {
        const Eigen::Map<const Vector> position(q + i * n, n), speed(u + i * n, n);
        const Eigen::Map<const Vector> acceleration(given + i * n, n);
        pin::rnea(a.model, a.data, position, speed, acceleration);
        Eigen::Map<Vector>(found + i * n, n) = a.data.tau;
    }
}

extern "C" void aba(void *arm, long count, const double *q, const double *u, const double *given,
    double *found)
{
    Arm &a = *static_cast<Arm *>(arm);
    const long n = a.model.nv;
    for (long i = 0; i < count; ++i) {
        const Eigen::Map<const Vector> position(q + i * n, n), speed(u + i * n, n);
        const Eigen::Map<const Vector> force(given + i * n, n);
        pin::aba(a.model, a.data, position, speed, force);
        Eigen::Map<Vector>(found + i * n, n) = a.data.ddq;
    }
}
