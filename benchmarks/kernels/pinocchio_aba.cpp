// Pinocchio's articulated-body algorithm on the cart with n links, state by state.
// Joint angles are relative there; the caller converts. Point masses at the ends of the links.
#include <pinocchio/multibody.hpp>
#include <pinocchio/algorithm/aba.hpp>

#include <string>

namespace pin = pinocchio;
using Vector = Eigen::VectorXd;

struct Chain {
    pin::Model model;
    pin::Data data;
};

static pin::Inertia point(double mass, double y)
{
    return pin::Inertia(mass, Eigen::Vector3d(0, y, 0), Eigen::Matrix3d::Zero());
}

extern "C" void *chain_new(int links, double g, const double *lengths, const double *masses)
{
    pin::Model model;
    model.gravity.linear(Eigen::Vector3d(0, -g, 0));
    pin::JointIndex joint = model.addJoint(0, pin::JointModelPX(), pin::SE3::Identity(), "cart");
    model.appendBodyToJoint(joint, point(masses[0], 0), pin::SE3::Identity());
    for (int i = 0; i < links; ++i) {
        pin::SE3 at = pin::SE3::Identity();
        if (i > 0)
            at.translation(Eigen::Vector3d(0, lengths[i - 1], 0));
        joint = model.addJoint(joint, pin::JointModelRZ(), at, "link" + std::to_string(i));
        model.appendBodyToJoint(joint, point(masses[i + 1], lengths[i]), pin::SE3::Identity());
    }
    return new Chain{model, pin::Data(model)};
}

extern "C" void loop(void *chain, long count, const double *q, const double *u,
    const double *forces, double *accelerations)
{
    Chain &c = *static_cast<Chain *>(chain);
    const long n = c.model.nv;
    for (long i = 0; i < count; ++i) {
        const Eigen::Map<const Vector> position(q + i * n, n), speed(u + i * n, n);
        const Eigen::Map<const Vector> force(forces + i * n, n);
        pin::aba(c.model, c.data, position, speed, force);
        Eigen::Map<Vector>(accelerations + i * n, n) = c.data.ddq;
    }
}
