//! Load histories: the ramp of the classic dialect and the tables of the others.

use super::model::NodeSet;

/// The table that does what the classic ramp does: 0 before `settling`, then a straight line to 1
/// within `rise` seconds. `None` where it is 1 from the start.
pub(super) fn table_of_ramp(start: f64, settling: f64, rise: f64) -> Option<Vec<(f64, f64)>> {
    let has_rise = rise > 0.0;
    let end = if has_rise { settling + rise } else { settling };
    if start >= end || start.is_nan() || end.is_nan() {
        return None;
    }
    let mut table = Vec::new();
    if start < settling {
        table.push((start, 0.0));
    }
    if has_rise {
        table.push((settling, 0.0));
        table.push((end, 1.0));
    } else {
        // At `settling` itself the factor is 1 already.
        table.push((settling.next_down(), 0.0));
    }
    Some(table)
}

/// The ramp that does what the tables of all loaded sets do: time of settling and of rise.
/// `Err` where there is none.
pub(super) fn ramp_of_tables(start: f64, sets: &[NodeSet]) -> Result<Option<(f64, f64)>, ()> {
    let mut ramp: Option<Option<(f64, f64)>> = None;
    for set in sets.iter().filter(|set| set.is_loaded()) {
        let of_set = ramp_of(start, &set.factors)?;
        match ramp {
            None => ramp = Some(of_set),
            Some(known) if known == of_set => {}
            Some(_) => return Err(()),
        }
    }
    Ok(ramp.flatten())
}

fn ramp_of(start: f64, factors: &[(f64, f64)]) -> Result<Option<(f64, f64)>, ()> {
    if factors.iter().all(|&(_, factor)| factor == 1.0) {
        return Ok(None);
    }
    let ramp = match *factors {
        [(begin, 0.0), (end, 1.0)] if begin <= start => (begin, end - begin),
        [(first, 0.0), (begin, 0.0), (end, 1.0)] if first <= start => (begin, end - begin),
        [(first, 0.0), (begin, 0.0)] if first <= start => (begin.next_up(), 0.0),
        _ => return Err(()),
    };
    Ok(Some(ramp))
}
