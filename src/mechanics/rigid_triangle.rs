//! Rigid triangle (spec `y2d3d.md` C.3): moves as one body under the contact
//! forces of its nodes. Gravity and node sets do not act on it.

use super::Vec2;

/// Motion of the three nodes of a rigid triangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidMotion {
    /// New positions, m.
    pub positions: [Vec2; 3],
    /// New velocities, m/s.
    pub velocities: [Vec2; 3],
    /// Mass lumped at each node (a third of the triangle's), kg.
    pub nodal_mass: f64,
}

/// Advances a rigid triangle by `dt` seconds.
#[must_use]
pub fn advance(
    density: f64,
    positions: &[Vec2; 3],
    velocities: &[Vec2; 3],
    forces: &[Vec2; 3],
    dt: f64,
) -> RigidMotion {
    let mean = |v: &[Vec2; 3]| (v[0] + v[1] + v[2]) / 3.0;
    let (mut centre, mut centre_velocity, force) =
        (mean(positions), mean(velocities), mean(forces));
    let arm = positions.map(|x| x - centre);
    let relative_velocity = velocities.map(|v| v - centre_velocity);
    let (mut moment, mut spin, mut inertia) = (0.0, 0.0, 0.0);
    for i in 0..3 {
        moment += arm[i].x * forces[i].y - arm[i].y * forces[i].x;
        spin += arm[i].x * relative_velocity[i].y - arm[i].y * relative_velocity[i].x;
        inertia += arm[i].x * arm[i].x + arm[i].y * arm[i].y;
    }
    let (x1, x2) = (positions[1] - positions[0], positions[2] - positions[0]);
    let nodal_mass = density * (x1.x * x2.y - x1.y * x2.x) / 6.0;
    inertia *= nodal_mass;
    centre_velocity += force * dt / nodal_mass;
    centre += dt * centre_velocity;
    let rate = (nodal_mass * spin) / inertia + moment * dt / inertia;
    let (sine, cosine) = (dt * rate).sin_cos();
    let turned = arm.map(|r| Vec2::new(r.x * cosine - r.y * sine, r.x * sine + r.y * cosine));
    RigidMotion {
        positions: turned.map(|r| centre + r),
        velocities: turned.map(|r| centre_velocity + Vec2::new(-rate * r.y, rate * r.x)),
        nodal_mass,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Without forces the centre keeps its velocity, the shape its size and
    /// the spin its rate.
    #[test]
    fn free_flight_keeps_momentum_and_shape() {
        let mut x = [Vec2::new(0.0, 0.0), Vec2::new(1.0, 0.0), Vec2::new(0.2, 0.8)];
        let centre = (x[0] + x[1] + x[2]) / 3.0;
        let omega = 2.0;
        let drift = Vec2::new(0.5, -0.25);
        let mut v = x.map(|p| drift + omega * Vec2::new(-(p - centre).y, (p - centre).x));
        for _ in 0..1000 {
            let motion = advance(2000.0, &x, &v, &[Vec2::zeros(); 3], 1e-3);
            (x, v) = (motion.positions, motion.velocities);
        }
        let moved = (x[0] + x[1] + x[2]) / 3.0;
        assert!((moved - (centre + drift)).norm() < 1e-10);
        assert!(((x[1] - x[0]).norm() - 1.0).abs() < 1e-10);
        assert!(((v[1] - v[0]).norm() - omega).abs() < 1e-9);
    }
}
