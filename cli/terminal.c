/* terminal.c - reads the width of the terminal and the encoding of the locale. */
#include "cli/terminal.h"

#include <langinfo.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

int pp_terminal_width(const char *output)
{
    struct winsize size;
    bool to_terminal = !output && isatty(STDOUT_FILENO);
    if (!to_terminal || ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0)
        return 80;
    return size.ws_col < 60    ? (size.ws_col ? 60 : 80)
           : size.ws_col > 200 ? 200
                               : size.ws_col;
}

bool pp_terminal_utf8(void)
{
    return strcmp(nl_langinfo(CODESET), "UTF-8") == 0;
}
