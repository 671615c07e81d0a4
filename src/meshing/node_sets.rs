//! Node sets of the deck: nodes that move alike, with their load-time tables.

use super::{
    MeshingError,
    loads::{Load, Side, Staging, Top, TopLoad, settlement, top_load, value},
    model::{Drive, History, Model, Motion},
};

/// Node sets and the nodes' numbers of them.
#[derive(Debug, Clone, PartialEq)]
pub struct NodeSets {
    /// The sets.
    pub sets: Vec<NodeSet>,
    /// Set of each node.
    pub of_node: Vec<usize>,
    /// Instants of all load-time tables \[s\]; empty if no factor varies.
    pub instants: Vec<f64>,
    /// Sum of the forces that the deck applies, over time.
    pub sums: Vec<LoadSum>,
}

/// Nodes that move alike.
#[derive(Debug, Clone, PartialEq)]
pub struct NodeSet<const D: usize = 2> {
    /// Name, for comments.
    pub name: String,
    /// What moves them.
    pub motion: Motion<D>,
}

/// What the loads amount to at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadSum {
    /// When \[s\].
    pub time_s: f64,
    /// Downward force that the deck applies to all nodes \[N\].
    pub applied_n: f64,
    /// Downward force that the loads describe \[N\].
    pub described_n: f64,
}

impl NodeSets {
    /// The sets of a model under loads, with tables that cover the time from 0 to `end_s`.
    ///
    /// # Errors
    /// If a load has no sense here, or the forces of the deck do not amount to the loads.
    pub fn of(
        model: &Model,
        loads: &[Load],
        staging: &Staging,
        end_s: f64,
    ) -> Result<Self, MeshingError> {
        staging.check()?;
        let copies = model.copies();
        let mut own: Vec<(String, Motion)> =
            vec![("free".to_owned(), Motion::FREE); model.mesh.nodes.len()];
        for support in &model.supports {
            for &node in &support.nodes {
                own[node] = (support.name.clone(), support.motion.clone());
            }
        }
        for load in loads {
            if let Some((side, velocity, history)) = settlement(load)? {
                settle(model, &mut own, side, velocity, &history)?;
            }
        }
        let x: Vec<f64> = model.top.iter().map(|&node| model.mesh.nodes[node][0]).collect();
        let mut on_top = Vec::new();
        for load in loads {
            on_top.extend(top_load(load, &Top { x: &x }, staging)?);
        }
        let amounts = apply(model, &mut own, &copies, &on_top)?;
        let (sets, of_node) = gather(own);
        let instants = instants(&sets, end_s);
        let mut node_sets = NodeSets { sets, of_node, instants, sums: Vec::new() };
        if !on_top.is_empty() {
            node_sets.sums = node_sets.sum_up(&copies, &amounts)?;
        }
        Ok(node_sets)
    }

    /// Adds up what the tables apply, at all instants and between them.
    fn sum_up(
        &self,
        copies: &[usize],
        described: &[History],
    ) -> Result<Vec<LoadSum>, MeshingError> {
        let mut copies_of = vec![0usize; self.sets.len()];
        for (&set, &n) in self.of_node.iter().zip(copies) {
            copies_of[set] += n;
        }
        let between = self.instants.windows(2).map(|w| f64::midpoint(w[0], w[1]));
        let mut times: Vec<f64> = self.instants.iter().copied().chain(between).collect();
        times.sort_by(f64::total_cmp);
        let largest = described.iter().flatten().map(|p| p[1].abs()).sum::<f64>().max(1.0);
        let mut sums = Vec::with_capacity(times.len());
        for time_s in times {
            let mut applied_n = 0.0;
            for (set, &n) in self.sets.iter().zip(&copies_of) {
                if let Drive::Force(force) = set.motion.drives[1] {
                    applied_n -= force * value(&set.motion.history, time_s) * n as f64;
                }
            }
            let described_n: f64 = described.iter().map(|history| value(history, time_s)).sum();
            if (applied_n - described_n).abs() > 1e-9 * largest {
                let (found, expected) = (applied_n, described_n);
                return Err(MeshingError::LoadSum { time: time_s, found, expected });
            }
            sums.push(LoadSum { time_s, applied_n, described_n });
        }
        Ok(sums)
    }
}

/// Lets a support settle.
fn settle(
    model: &Model,
    own: &mut [(String, Motion)],
    side: Side,
    velocity: f64,
    history: &History,
) -> Result<(), MeshingError> {
    let name = match side {
        Side::Left => "base left",
        Side::Right => "base right",
    };
    let Some(support) = model.supports.iter().find(|support| support.name == name) else {
        let expected = "this kind of mesh has no support that can settle";
        return Err(MeshingError::parameter("loads.type", "settlement", expected));
    };
    let drives = [Drive::Velocity(0.0), Drive::Velocity(-velocity)];
    for &node in &support.nodes {
        let motion = Motion { drives, later: None, history: history.clone() };
        own[node] = (format!("{name}, settling"), motion);
    }
    Ok(())
}

/// Gives the nodes of the top their share of the loads. Returns what each load amounts to.
fn apply(
    model: &Model,
    own: &mut [(String, Motion)],
    copies: &[usize],
    loads: &[TopLoad],
) -> Result<Vec<History>, MeshingError> {
    let described = loads.iter().map(|load| {
        load.course.iter().zip(&load.total).map(|((time, _), &total)| [*time, total]).collect()
    });
    for (k, &node) in model.top.iter().enumerate() {
        let histories: Vec<History> = loads
            .iter()
            .map(|load| load.course.iter().map(|(time, f)| [*time, f[k]]).collect())
            .filter(|history: &History| history.iter().any(|point| point[1] != 0.0))
            .collect();
        if histories.is_empty() {
            continue;
        }
        if own[node].1 != Motion::FREE {
            let expected = format!("a node of the top that is free, not `{}`", own[node].0);
            return Err(MeshingError::parameter("loads", "given", &expected));
        }
        let times = union(&histories);
        let sum = |time: f64| histories.iter().map(|history| value(history, time)).sum::<f64>();
        let forces: Vec<f64> = times.iter().map(|&time| sum(time)).collect();
        let largest = forces.iter().fold(0.0_f64, |l, f| if f.abs() > l.abs() { *f } else { l });
        let history = times.iter().zip(&forces).map(|(&t, f)| [t, f / largest]).collect();
        let drives = [Drive::Force(0.0), Drive::Force(-largest / copies[node].max(1) as f64)];
        own[node] = ("loaded".to_owned(), Motion { drives, later: None, history });
    }
    Ok(described.collect())
}

/// Makes a set of nodes that move alike; free ones are set 0.
pub(super) fn gather<const D: usize>(
    own: Vec<(String, Motion<D>)>,
) -> (Vec<NodeSet<D>>, Vec<usize>) {
    let mut sets = vec![NodeSet { name: "free".to_owned(), motion: Motion::FREE }];
    let of_node = own
        .into_iter()
        .map(|(name, motion)| {
            sets.iter().position(|set| set.motion == motion && set.name == name).unwrap_or_else(
                || {
                    sets.push(NodeSet { name, motion });
                    sets.len() - 1
                },
            )
        })
        .collect();
    (sets, of_node)
}

/// All instants of some histories, ascending.
fn union<'a>(histories: impl IntoIterator<Item = &'a History>) -> Vec<f64> {
    let mut times: Vec<f64> =
        histories.into_iter().flatten().map(|point| point[0].max(0.0)).collect();
    times.sort_by(f64::total_cmp);
    times.dedup_by(|b, a| *b - *a < 1e-12);
    times
}

/// Instants of the tables, from 0 to beyond the end: outside a table the factor is 1.
pub(super) fn instants<const D: usize>(sets: &[NodeSet<D>], end_s: f64) -> Vec<f64> {
    let mut times = union(sets.iter().map(|set| &set.motion.history));
    if times.is_empty() {
        return times;
    }
    if times[0] > 0.0 {
        times.insert(0, 0.0);
    }
    let beyond = times[times.len() - 1].max(end_s) + 1.0;
    times.push(beyond);
    times
}
