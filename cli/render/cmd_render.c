/* cmd_render.c - the command render: makes a picture of the light in a room. */
#include "cli/command.h"
#include "cli/render/make_picture.h"
#include "cli/message.h"
#include "cli/moment_choice.h"
#include "cli/output.h"
#include "cli/render/render_choice.h"
#include "cli/render/render_options.h"
#include "cli/rooms.h"
#include "cli/render/show_picture.h"
#include "model/base/read_file.h"
#include "model/room/position.h"

static const struct pp_option external_option[] = {
    {"external", 0, "LUX",
     "External horizontal illuminance in lux (default 10000); luminances and "
     "illuminances are proportional to it.",
     pp_options_read_lux, offsetof(struct pp_room_options, study.external_lux)},
    {0},
};

static const char about[] =
    "Renders a picture of the light in a room to -o FILE. A .hdr or .pfm file stores "
    "the light as numbers, a .png file displays it, and a .pdf or .svg file puts it on "
    "a sheet. --false-colour adds a scale and contours. FILE is a room file; - is "
    "standard input.";

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

/* Writes the standard errors of the pixels as a picture in a numeric format. */
static enum pp_exit write_errors(const struct pp_made_picture *made, const char *path)
{
    struct pp_error err = {0};
    struct pp_output output;
    struct pp_shown_picture errors = made->shown;
    struct pp_picture_format format;
    errors.picture = made->errors;
    pp_picture_format_of(&format, path);
    enum pp_status status = pp_output_open(&output, path, &err);
    if (status == PP_OK)
        status = pp_show_picture_numbers(&errors, format.numbers, output.stream, &err);
    status = pp_output_close(&output, status, &err);
    return status == PP_OK ? PP_EXIT_DONE : pp_message_error(&err);
}

/* Warns if the picture is black because no light reaches the visible surfaces. */
static void say_if_black(const struct pp_picture *picture)
{
    size_t count = 3 * (size_t)picture->width * (size_t)picture->height;
    for (size_t i = 0; i < count; i++)
        if (picture->rgb[i] > 0.0f)
            return;
    pp_message("the picture is black, because no light reaches the surfaces in view");
}

/* Warns if the eye of a perspective or fisheye view is outside the room. */
static void say_if_outside(const struct pp_world *world, const struct pp_camera *camera)
{
    if (camera->kind != PP_VIEW_PARALLEL && !pp_position_in_room(world, camera->eye))
        pp_message("the eye is outside the room, so the picture shows the room from "
                   "outside");
}

static enum pp_exit render_room(const struct pp_study_room *room,
                                const struct pp_render_choice *choice,
                                const struct pp_room_options *options)
{
    struct pp_made_picture made = {0};
    struct pp_error err = {0};
    enum pp_status status =
        pp_make_picture(&made, room->world, &room->light, choice, options, &err);
    enum pp_exit result = PP_EXIT_DONE;
    if (status == PP_INTERRUPTED) {
        pp_message("%s", err.message);
        result = PP_EXIT_INTERRUPTED;
    } else if (status != PP_OK) {
        result = pp_message_error(&err);
    } else {
        result = write_output(&made.shown, choice, options->output);
        if (result == PP_EXIT_DONE && choice->errors)
            result = write_errors(&made, choice->errors);
        if (result == PP_EXIT_DONE)
            say_if_black(&made.shown.picture);
        if (result == PP_EXIT_DONE)
            say_if_outside(room->world, &made.shown.camera);
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

/* Replaces the sky of the room file by the sky and sun of the moment, and the external
 * illuminance by that of this sky. */
static enum pp_exit take_moment(struct pp_study_room *room,
                                struct pp_moment_choice *choice,
                                struct pp_room_options *options)
{
    struct pp_moment moment;
    struct pp_error own = {0}, err = {0};
    enum pp_exit result = pp_moment_choice_load(choice, options->study.strict);
    if (result != PP_EXIT_DONE)
        return result;
    enum pp_status status = pp_moment_choice_find(&moment, choice, room->world, &own);
    if (status == PP_OK)
        status = pp_moment_turn_slats(room->world, &moment, &own);
    if (status == PP_OK)
        status = pp_moment_light(&room->light, &moment, room->world->north_rad, &own);
    if (status == PP_OK) {
        options->study.external_lux = moment.sky.diffuse_lx;
        return PP_EXIT_DONE;
    }
    pp_fail(&err, status, "%s: %s", pp_read_file_title(room->file), own.message);
    return pp_message_error(&err);
}

static enum pp_exit render_or_show(const struct pp_render_choice *choice,
                                   struct pp_moment_choice *moment,
                                   struct pp_room_options *options, char **files)
{
    struct pp_error err = {0};
    enum pp_exit result;
    enum pp_status status = pp_output_try(options->output, &err);
    if (status == PP_OK && choice->checkpoint)
        status = pp_output_try(choice->checkpoint, &err);
    if (status == PP_OK && choice->errors)
        status = pp_output_try(choice->errors, &err);
    if (status != PP_OK)
        return pp_message_error(&err);
    if (choice->from_picture)
        return show_file(choice, options);
    struct pp_rooms rooms = {0};
    result = pp_rooms_load(&rooms, "render", files, 1, options);
    if (result == PP_EXIT_DONE && rooms.count != 1) {
        pp_fail(&err, PP_BAD_INPUT,
                "there are %d rooms, but a picture shows one; expected --room NAME",
                rooms.count);
        result = pp_message_usage("render", &err);
    }
    if (result == PP_EXIT_DONE && pp_moment_choice_said(moment))
        result = take_moment(&rooms.list[0], moment, options);
    if (result == PP_EXIT_DONE)
        result = render_room(&rooms.list[0], choice, options);
    pp_rooms_clear(&rooms);
    return result;
}

struct render_options {
    struct pp_room_options room;
    struct pp_render_choice choice;
    struct pp_moment_choice moment;
};

#define PLACE(member) offsetof(struct render_options, member)

static const struct pp_option_group groups[] = {
    {"View", pp_render_view_options, PLACE(choice)},
    {"Picture", pp_render_picture_options, PLACE(choice)},
    {"Picture", external_option, PLACE(room)},
    {"Picture", pp_room_sky_options, PLACE(room)},
    {"Picture", pp_moment_when_option, PLACE(moment)},
    {"Picture", pp_moment_weather_option, PLACE(moment)},
    {"Picture", pp_room_seed_options, PLACE(room)},
    {"Picture", pp_room_plain_option, PLACE(room)},
    {"Irradiance cache", pp_cache_choice_options, PLACE(choice.cache)},
    {"Display", pp_render_shown_options, PLACE(choice)},
    {"Output", pp_room_output_options, PLACE(room)},
    {0},
};

static void init_render_options(void *values)
{
    *(struct render_options *)values = (struct render_options){
        .room = pp_room_options_none, .choice = pp_render_choice_default()};
}

/* Checks the options for a moment. Sunlight requires next-event estimation. A picture
 * of a moment cannot show daylight factors and cannot be read from a file. */
static enum pp_status check_moment(const struct render_options *options,
                                   struct pp_error *err)
{
    const char *given = options->moment.sky ? "--sky" : "--when";
    if (options->choice.from_picture)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s is for rendering; it cannot be combined with --from-picture",
                       given);
    if (options->choice.quantity.is == PP_DAYLIGHT_FACTOR)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s: a sky with a sun has no daylight factor; expected "
                       "--quantity luminance or illuminance",
                       given);
    if (options->room.study.method_options.plain)
        return pp_fail(
            err, PP_BAD_INPUT,
            "%s: random paths of --plain never hit the sun; expected no --plain",
            given);
    return PP_OK;
}

static enum pp_status check_render_command(void *values, char **files, int file_count,
                                           struct pp_error *err)
{
    struct render_options *options = values;
    (void)files;
    enum pp_status status =
        pp_moment_choice_settle(&options->moment, &options->room, err);
    if (status == PP_OK && pp_moment_choice_said(&options->moment))
        status = check_moment(options, err);
    return status == PP_OK ? pp_render_choice_check(&options->choice, &options->room,
                                                    file_count, err)
                           : status;
}

static enum pp_exit run_render(void *values, char **files, int file_count)
{
    struct render_options *options = values;
    (void)file_count;
    return render_or_show(&options->choice, &options->moment, &options->room, files);
}

static void clear_render_options(void *values)
{
    struct render_options *options = values;
    pp_render_choice_clear(&options->choice);
    pp_moment_choice_clear(&options->moment);
    pp_room_options_clear(&options->room);
}

const struct pp_command pp_command_render = {
    .name = "render",
    .summary = "pictures of the light in a room",
    .operands = "[FILE]",
    .about = about,
    .groups = groups,
    .size = sizeof(struct render_options),
    .init = init_render_options,
    .check = check_render_command,
    .run = run_render,
    .clear = clear_render_options,
};
