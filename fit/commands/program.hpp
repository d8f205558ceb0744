#pragma once

namespace trunk {

/// Does what the command line asks for and returns the exit code. All errors are printed here. The first
/// argument is the name of the program.
int run_program(int argc, char** argv);

}  // namespace trunk
