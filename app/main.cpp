// Where does the program start? The command line decides what it does.
#include "app/cli.h"

int main(int argc, char** argv) {
    return halfdisk::runCommandLine(argc, argv);
}
