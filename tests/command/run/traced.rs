//! The program under `ptrace`: its system calls, one after the other, each of which can fail or be the last.

#![allow(unsafe_code)]

use std::os::unix::process::{CommandExt, ExitStatusExt};
use std::process::{Command, ExitStatus};

#[derive(Clone, Copy, Debug)]
pub enum Fault {
    /// The system does not do it and answers with this error.
    Error(i32),
    /// The process is killed before it is done.
    Kill,
}

/// Runs the program to its end, with the fault at the call of that index. Returns the numbers of its calls up to the fault, and the exit status.
#[allow(clippy::zombie_processes)] // It is waited for by its number.
pub fn run(command: &mut Command, fault: Option<(usize, Fault)>) -> (Vec<i64>, ExitStatus) {
    let trace_me = || match ptrace(libc::PTRACE_TRACEME, 0, 0, 0) {
        -1 => Err(std::io::Error::last_os_error()),
        _ => Ok(()),
    };
    // SAFETY: between fork and exec this makes one system call and takes no memory.
    unsafe { command.pre_exec(trace_me) };
    let child = command.spawn().unwrap_or_else(|error| panic!("it cannot be traced: {error}"));
    let process = child.id() as libc::pid_t;
    wait(process);
    let options = libc::PTRACE_O_TRACESYSGOOD | libc::PTRACE_O_EXITKILL;
    assert_eq!(ptrace(libc::PTRACE_SETOPTIONS, process, 0, options as usize), 0);
    let (mut calls, mut inside, mut pending, mut signal) = (Vec::new(), false, None, 0);
    loop {
        ptrace(libc::PTRACE_SYSCALL, process, 0, signal);
        signal = 0;
        let status = wait(process);
        if libc::WIFEXITED(status) || libc::WIFSIGNALED(status) {
            return (calls, ExitStatus::from_raw(status));
        }
        if libc::WSTOPSIG(status) != libc::SIGTRAP | 0x80 {
            signal = libc::WSTOPSIG(status) as usize;
            continue;
        }
        inside = !inside;
        if inside {
            let mut registers = registers(process);
            let index = calls.len();
            calls.push(registers.orig_rax as i64);
            match fault.filter(|(at, _)| *at == index) {
                // SAFETY: a signal to a child that is not waited for yet.
                Some((_, Fault::Kill)) => drop(unsafe { libc::kill(process, libc::SIGKILL) }),
                Some((_, Fault::Error(error))) => {
                    registers.orig_rax = u64::MAX;
                    set_registers(process, &registers);
                    pending = Some(error);
                }
                None => {}
            }
        } else if let Some(error) = pending.take() {
            let mut registers = registers(process);
            registers.rax = i64::from(-error) as u64;
            set_registers(process, &registers);
            // The rest of its way is its own: nothing looks at its later calls.
            assert_eq!(ptrace(libc::PTRACE_DETACH, process, 0, 0), 0);
            return (calls, ExitStatus::from_raw(wait(process)));
        }
    }
}

fn wait(process: libc::pid_t) -> i32 {
    let mut status = 0;
    // SAFETY: the status is written to a variable that lives here.
    assert_eq!(unsafe { libc::waitpid(process, &raw mut status, 0) }, process);
    status
}

fn registers(process: libc::pid_t) -> libc::user_regs_struct {
    // SAFETY: numbers alone, for which nothing but zeros is a value.
    let mut registers: libc::user_regs_struct = unsafe { std::mem::zeroed() };
    assert_eq!(ptrace(libc::PTRACE_GETREGS, process, 0, &raw mut registers as usize), 0);
    registers
}

fn set_registers(process: libc::pid_t, registers: &libc::user_regs_struct) {
    assert_eq!(ptrace(libc::PTRACE_SETREGS, process, 0, std::ptr::from_ref(registers) as usize), 0);
}

fn ptrace(request: libc::c_uint, process: libc::pid_t, address: usize, data: usize) -> libc::c_long {
    // SAFETY: every request above reads or writes one number, or registers that outlive the call.
    unsafe { libc::ptrace(request, process, address, data) }
}
