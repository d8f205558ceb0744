#include "commands/program.hpp"

int main(int argc, char** argv) {
  return trunk::run_program(argc, argv);
}
