//! Derived stresses against closed forms.

use proptest::prelude::*;
use ypsilon_converters::stress_measures::{
    SymmetricTensor, maximum_shear, mean, plane, principal, tresca, von_mises,
};

fn close(a: f64, b: f64, scale: f64) -> bool {
    (a - b).abs() <= 1e-13 * scale.max(f64::MIN_POSITIVE)
}

#[test]
fn uniaxial_tension() {
    for stress in [[5.0, 0.0, 0.0], [0.0, 5.0, 0.0], [0.0, 0.0, 5.0]] {
        let [xx, yy, zz] = stress;
        let tensor = [xx, yy, zz, 0.0, 0.0, 0.0];
        assert_eq!(principal(&tensor), [5.0, 0.0, 0.0]);
        assert_eq!(von_mises(&tensor), 5.0);
        assert_eq!(tresca(&tensor), 5.0);
        assert_eq!(maximum_shear(&tensor), 2.5);
    }
}

#[test]
fn pure_shear_in_each_plane() {
    for place in 3..6 {
        let mut tensor = [0.0; 6];
        tensor[place] = 2.0;
        let [a, b, c] = principal(&tensor);
        assert!(close(a, 2.0, 2.0) && close(b, 0.0, 2.0) && close(c, -2.0, 2.0));
        assert!(close(von_mises(&tensor), 12.0_f64.sqrt(), 2.0));
        assert!(close(tresca(&tensor), 4.0, 4.0));
    }
}

#[test]
fn hydrostatic_pressure_has_no_deviator() {
    let tensor = [-7.0, -7.0, -7.0, 0.0, 0.0, 0.0];
    assert_eq!(mean(&tensor), -7.0);
    assert_eq!(von_mises(&tensor), 0.0);
    assert_eq!(tresca(&tensor), 0.0);
}

#[test]
fn the_out_of_plane_stress_takes_its_place_among_the_principal_stresses() {
    // In plane 4 and 2; out of plane above, between, below.
    assert_eq!(principal(&plane(3.0, 3.0, 5.0, 1.0)), [5.0, 4.0, 2.0]);
    assert_eq!(principal(&plane(3.0, 3.0, 3.0, 1.0)), [4.0, 3.0, 2.0]);
    assert_eq!(principal(&plane(3.0, 3.0, 0.0, 1.0)), [4.0, 2.0, 0.0]);
    assert_eq!(tresca(&plane(3.0, 3.0, 0.0, 1.0)), 4.0);
    // von Mises of a plane state: σxx² - σxxσyy + σyy² + 3σxy² when σzz = 0.
    assert!(close(von_mises(&plane(3.0, 3.0, 0.0, 1.0)), 12.0_f64.sqrt(), 4.0));
}

#[test]
fn components_that_are_not_finite_show() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for place in 0..6 {
            let mut tensor = [1.0, 2.0, 3.0, 0.0, 0.0, 0.0];
            tensor[place] = bad;
            assert!(principal(&tensor).iter().all(|v| v.is_nan()));
            assert!(tresca(&tensor).is_nan());
            assert!(!von_mises(&tensor).is_finite());
        }
    }
}

/// Q diag(values) Qᵀ with Q from three Euler angles.
fn rotated(values: [f64; 3], [a, b, c]: [f64; 3]) -> SymmetricTensor {
    let product = |p: [[f64; 3]; 3], q: [[f64; 3]; 3]| -> [[f64; 3]; 3] {
        std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| p[i][k] * q[k][j]).sum()))
    };
    let z = |t: f64| [[t.cos(), -t.sin(), 0.0], [t.sin(), t.cos(), 0.0], [0.0, 0.0, 1.0]];
    let x = [[1.0, 0.0, 0.0], [0.0, b.cos(), -b.sin()], [0.0, b.sin(), b.cos()]];
    let q = product(product(z(a), x), z(c));
    let entry = |i: usize, j: usize| (0..3).map(|k| q[i][k] * values[k] * q[j][k]).sum();
    [entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(1, 2), entry(0, 2)]
}

fn value() -> impl Strategy<Value = f64> {
    prop_oneof![-1e7..1e7_f64, Just(0.0), Just(1.0), -1e-3..1e-3_f64]
}

proptest! {
    #[test]
    fn rotations_change_nothing(
        values in [value(), value(), value()],
        repeated: bool,
        angles in [0.0..6.3_f64, 0.0..3.2_f64, 0.0..6.3_f64],
    ) {
        let mut values = values;
        if repeated {
            values[1] = values[0];
        }
        let tensor = rotated(values, angles);
        let scale = values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let found = principal(&tensor);
        values.sort_by(|a, b| b.total_cmp(a));
        for (found, value) in found.iter().zip(values) {
            prop_assert!(close(*found, value, 10.0 * scale), "{found} {value}");
        }
        let [a, b, c] = values;
        let mises = (0.5 * ((a - b).powi(2) + (b - c).powi(2) + (c - a).powi(2))).sqrt();
        // Rounding of the rotation is amplified where the three values nearly coincide.
        prop_assert!((von_mises(&tensor) - mises).abs() <= 1e-12 * scale);
        prop_assert!(close(tresca(&tensor), a - c, 20.0 * scale));
        // von Mises lies between Tresca·√3/2 and Tresca.
        let tresca = tresca(&tensor);
        prop_assert!(von_mises(&tensor) <= tresca + 1e-12 * scale);
        prop_assert!(von_mises(&tensor) >= 0.75_f64.sqrt() * tresca - 1e-12 * scale);
    }
}
