#include "cli/cli.hh"

int main(int argc, char** argv) { return pongsim::cli::run(argc, argv); }
