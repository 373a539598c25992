/* pane_cell.c - interpolation between the nodes of a cell. */
#include "methods/exact/pane_cell.h"

enum { NODES = PP_PANE_CELL_NODES };

const double pp_pane_cell_nodes[NODES] = {
    -0.9749279121818236, -0.7818314824680298, -0.4338837391175582, 0.0,
    0.43388373911755806, 0.7818314824680295,  0.9749279121818237};
static const double barycentric[NODES] = {
    0.2225209339563144, -0.6234898018587335, 0.9009688679024191, -1.0,
    0.9009688679024191, -0.6234898018587339, 0.2225209339563141};

void pp_pane_cell_weights(double weights[NODES], double t)
{
    double sum = 0.0;
    for (int i = 0; i < NODES; i++) {
        double apart = t - pp_pane_cell_nodes[i];
        if (apart == 0.0) {
            for (int k = 0; k < NODES; k++)
                weights[k] = k == i;
            return;
        }
        weights[i] = barycentric[i] / apart;
        sum += weights[i];
    }
    for (int i = 0; i < NODES; i++)
        weights[i] /= sum;
}
