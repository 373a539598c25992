/* render - a picture of a room's light. */
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/render/make_picture.h"
#include "cli/message.h"
#include "cli/output.h"
#include "cli/render/render_choice.h"
#include "cli/rooms.h"
#include "cli/render/show_picture.h"

static const struct pp_option external_option[] = {
    {"external", 0, "LUX",
     "Horizontal illuminance outside, in lux (default 10000), which luminances and "
     "illuminances are in proportion to.",
     pp_options_read_lux, offsetof(struct pp_room_options, external_lux)},
    {0},
};

static const char about[] =
    "Draws a picture of the light in a room to -o FILE: .hdr or .pfm keep the light as "
    "numbers, .png shows it, .pdf and .svg lay it out on a sheet; --false-colour sets "
    "a "
    "scale and level lines beside. FILE is a room file; - is standard input.";

static enum pp_exit write_output(const struct pp_shown_picture *shown,
                                 const struct pp_render_choice *choice,
                                 const char *path)
{
    struct pp_error err = {0};
    struct pp_output output;
    enum pp_status status = pp_output_open(&output, path, &err);
    if (status == PP_OK)
        status = pp_show_picture(shown, choice, path, output.stream, &err);
    status = pp_output_close(&output, status, &err);
    if (status != PP_OK)
        return pp_message_error(&err);
    return PP_EXIT_DONE;
}

/* Would the output be written? Better asked before an hour's work. */
static enum pp_exit try_output(const char *path)
{
    struct pp_error err = {0};
    struct pp_output output;
    if (pp_output_open(&output, path, &err) != PP_OK)
        return pp_message_error(&err);
    pp_output_clear(&output);
    return PP_EXIT_DONE;
}

/* Where no light is, nothing can be shown: better said than wondered at. */
static void say_if_black(const struct pp_picture *picture)
{
    size_t count = 3 * (size_t)picture->width * (size_t)picture->height;
    for (size_t i = 0; i < count; i++)
        if (picture->rgb[i] > 0.0f)
            return;
    pp_message("the picture is black: no light reaches what it shows");
}

static enum pp_exit render_room(const struct pp_loaded_room *room,
                                const struct pp_render_choice *choice,
                                const struct pp_room_options *options)
{
    struct pp_made_picture made = {0};
    struct pp_error err = {0};
    enum pp_status status = pp_make_picture(&made, room->world, choice, options, &err);
    enum pp_exit result = PP_EXIT_DONE;
    if (status == PP_INTERRUPTED) {
        pp_message("%s", err.message);
        result = PP_EXIT_INTERRUPTED;
    } else if (status != PP_OK) {
        result = pp_message_error(&err);
    } else {
        result = write_output(&made.shown, choice, options->output);
        if (result == PP_EXIT_DONE)
            say_if_black(&made.shown.picture);
    }
    pp_make_picture_clear(&made);
    return result;
}

static enum pp_exit show_file(const struct pp_render_choice *choice,
                              const struct pp_room_options *options)
{
    struct pp_error err = {0};
    struct pp_shown_picture shown;
    if (pp_show_picture_read(&shown, choice, &err) != PP_OK)
        return pp_message_error(&err);
    enum pp_exit result = write_output(&shown, choice, options->output);
    pp_picture_clear(&shown.picture);
    return result;
}

static enum pp_exit run(const struct pp_render_choice *choice,
                        const struct pp_room_options *options, char **files)
{
    enum pp_exit result = try_output(options->output);
    if (result == PP_EXIT_DONE && choice->checkpoint)
        result = try_output(choice->checkpoint);
    if (result != PP_EXIT_DONE)
        return result;
    if (choice->from_picture)
        return show_file(choice, options);
    struct pp_rooms rooms = {0};
    result = pp_rooms_load(&rooms, "render", files, 1, options);
    if (result == PP_EXIT_DONE && rooms.count != 1) {
        struct pp_error err;
        pp_fail(&err, PP_BAD_INPUT,
                "there are %d rooms, and a picture is of one; expected --room NAME",
                rooms.count);
        result = pp_message_usage("render", &err);
    }
    if (result == PP_EXIT_DONE)
        result = render_room(&rooms.list[0], choice, options);
    pp_rooms_clear(&rooms);
    return result;
}

enum pp_exit cmd_render(int argc, char **argv)
{
    struct pp_room_options options = pp_room_options_none;
    struct pp_render_choice choice = pp_render_choice_default();
    const struct pp_option_group groups[] = {
        {"The view", pp_render_view_options, &choice},
        {"The picture", pp_render_picture_options, &choice},
        {"The picture", external_option, &options},
        {"The picture", pp_room_sky_options, &options},
        {"The picture", pp_room_seed_options, &options},
        {"Irradiance cache", pp_cache_choice_options, &choice.cache},
        {"How it is shown", pp_render_shown_options, &choice},
        {"Output", pp_room_output_options, &options},
        {0},
    };
    const struct pp_command_line line = {"render", "[FILE]", about, groups, NULL};

    struct pp_error err = {0};
    int file_count;
    bool wants_help;
    enum pp_exit exit_status;
    enum pp_status status =
        pp_options_read(&line, argc, argv, &file_count, &wants_help, &err);
    if (status == PP_OK && !wants_help)
        status = pp_render_choice_check(&choice, &options, file_count, &err);
    if (options.external_lux == 0.0)
        options.external_lux = 1e4;
    if (pp_command_line_starts(&line, argv, file_count, status, wants_help, &err,
                               &exit_status))
        exit_status = run(&choice, &options, argv);
    pp_render_choice_clear(&choice);
    pp_room_options_clear(&options);
    return exit_status;
}
