/* draw_model_net.c - net of a room's scale model, to be cut out and folded. */
#include "api/chart_kind.h"
#include "charts/net/net_chart.h"

static enum pp_status draw_model_net(struct pp_canvas *canvas,
                                     struct pp_study_room *room,
                                     const struct pp_study_options *study,
                                     const struct pp_chart_choice *choice,
                                     bool *finished, struct pp_error *err)
{
    (void)study, (void)finished;
    const struct pp_model_options *options = &choice->model;
    const struct pp_model_net net = {
        .world = room->world,
        .scale = options->scale > 0.0 ? options->scale : 20.0,
        .box = options->has_box ? options->box
                                : (struct pp_mirror_box){.rho = 0.85, .height = 0.5}};
    return pp_net_chart_draw(canvas, &net, err);
}

const struct pp_chart_kind pp_draw_model_net = {
    .name = "model-net",
    .summary = "the room as a scale model to cut out and fold",
    .paper = PP_PAPER_A3,
    .draw = draw_model_net,
};
