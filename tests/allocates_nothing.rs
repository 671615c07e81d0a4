//! The step loop allocates nothing once it is warm.

mod support;

use std::{
    alloc::{GlobalAlloc, Layout, System},
    cell::Cell,
    path::Path,
};
use support::scenes::{reference_scene, step};
use ypsilon::{
    scene::Profile,
    session::load,
    simulation::{AnySimulation, Simulation, SolverOptions},
};

/// Counts what it passes on to the system.
struct Counting;

thread_local! {
    /// Allocations of this thread: what the test harness and idle threads of the
    /// pool do in the meantime does not count.
    static ALLOCATIONS: Cell<u64> = const { Cell::new(0) };
}

fn count() {
    // a thread that is ending has no counter any more
    let _ = ALLOCATIONS.try_with(|n| n.set(n.get() + 1));
}

// SAFETY: every call is passed on unchanged to the system's allocator.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count();
        // SAFETY: the caller's promises are the system's demands.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: as above.
        unsafe { System.dealloc(pointer, layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count();
        // SAFETY: as above.
        unsafe { System.realloc(pointer, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

fn allocations_between(case: &str, warm: u64, end: u64) -> u64 {
    let mut simulation = Simulation::new(reference_scene(case));
    simulation.prepare().expect("the deck leaves room for its joints");
    (0..warm).for_each(|_| step(&mut simulation));
    let before = ALLOCATIONS.get();
    (warm..end).for_each(|_| step(&mut simulation));
    ALLOCATIONS.get() - before
}

fn allocations_in_space(case: &str, warm: u64, end: u64) -> u64 {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let deck = root.join(format!("tests/data/split3d/{case}/{case}.y"));
    let loaded = load(&deck, None, Profile::default(), SolverOptions::default());
    let simulation = loaded.expect("a sound deck").simulation.and_then(AnySimulation::into_spatial);
    let mut simulation = simulation.expect("a deck in space");
    let mut step = || {
        simulation.evaluate_forces();
        simulation.advance();
    };
    (0..warm).for_each(|_| step());
    let before = ALLOCATIONS.get();
    (warm..end).for_each(|_| step());
    ALLOCATIONS.get() - before
}

#[test]
fn warm_steps_in_space_allocate_nothing() {
    // after the lists have seen most contacts
    assert_eq!(allocations_in_space("t3d_impact", 2500, 3000), 0);
    // blocks that slide
    assert_eq!(allocations_in_space("t3d_friction", 1000, 2000), 0);
    // joints that soften and break
    assert_eq!(allocations_in_space("t3d_joint_tension", 2500, 3000), 0);
}

#[test]
fn warm_steps_allocate_nothing() {
    // friction, contact detected anew 100 times, couples added and dropped; the
    // list has seen its largest number of couples after 4000 steps
    assert_eq!(allocations_between("d_slide_fr0.3", 4000, 20_000), 0);
    // contact between blocks at rest
    assert_eq!(allocations_between("k_arch_fr0.7", 10, 4000), 0);
    // joints that soften and break
    assert_eq!(allocations_between("n_wall_tension", 10, 4000), 0);
    // pressure on edges with a load-time history
    assert_eq!(allocations_between("i_pres_fac", 2, 30), 0);
    // classic: couples in order, fractures with apertures
    assert_eq!(allocations_between("classic/j_wall_dry", 400, 2900), 0);
    assert_eq!(allocations_between("classic/e_joint_tension", 1500, 2900), 0);
}
