#include "fuel/command.hh"

int main(int argc, char** argv) { return pongsim::fuel::runCommand(argc, argv); }
