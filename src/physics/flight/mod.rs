pub(crate) mod air;
mod bends;
pub(crate) mod implicit;
pub(crate) mod linked;
pub(crate) mod liquid;
pub(crate) mod steps;
