fn main() -> std::process::ExitCode {
    resultant::cli::main()
}
