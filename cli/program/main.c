/* main.c - pepperpot, daylight factors by hand and by ray: the list of commands. */
#include "cli/program/program.h"

static const struct pp_command *const commands[] = {
    &pp_command_df,
    &pp_command_chart,
    &pp_command_render,
    &pp_command_assess,
    &pp_command_report,
    &pp_command_size,
    &pp_command_availability,
    &pp_command_validate,
    &pp_command_compare,
    &pp_command_atlas,
    &pp_command_export,
    &pp_command_import,
    NULL,
};

int main(int argc, char **argv)
{
    return pp_program(argc, argv, commands);
}
