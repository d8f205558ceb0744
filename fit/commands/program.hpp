#pragma once

namespace trunk {

/// The whole program: reads the command line, does what it says, returns the exit code. The first argument is
/// the program's name.
int run_program(int argc, char** argv);

}  // namespace trunk
