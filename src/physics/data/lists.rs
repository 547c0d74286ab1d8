//! Lists whose buffers are kept from step to step.

/// Sets the length and all values of a list.
pub(crate) fn refill<T: Clone>(list: &mut Vec<T>, count: usize, value: T) {
    list.clear();
    list.resize(count, value);
}
