/* en15193.h - electric light saved by daylight, according to the tables of EN
 * 15193:2007 [EN15193].
 *
 * For the zone along a facade of depth a_D and width b_D:
 *
 *   D_C = (4.13 + 20.0 I_T - 1.36 I_De) I_O        per cent, for openings without glass
 *
 *   I_T = A_C/(a_D b_D)           A_C: area of the openings
 *   I_De = a_D/(h_Li - h_Ta)      heights of lintel and working plane; at most 2.5
 *   I_O = cos(1.5 g)              g: altitude of the obstruction; 0 if g >= 60 degrees
 *
 * Daylight is strong if D_C is at least 6 %, medium if at least 4 %, and weak if at
 * least 2 %. F_D,S is the fraction of the light that daylight can supply: F_D,S = a + b
 * x latitude (degrees, 38 to 60), with a and b from a table by class and target
 * illuminance. F_D,C is the fraction of this supply that the control uses. The zone
 * saves F_D,S F_D,C of its energy. The rest of the room saves nothing.
 *
 * The text of the standard was not available. The numbers are taken from public copies
 * of its draft and from the literature. b_D is assumed to be the width of the room.
 */
#ifndef PP_STUDIES_LIGHTING_EN15193_H
#define PP_STUDIES_LIGHTING_EN15193_H

#include "model/results/sheets/lighting_sheet.h"
#include "model/room/world.h"

/* D_C as a fraction, at least 0. */
double pp_en15193_factor(double I_T, double I_De, double I_O);

/* Class of a D_C: 3 strong, 2 medium, 1 weak, 0 none. */
int pp_en15193_class(double D_C);

/* F_D,S of a class from 1 to 3. NAN if there is no value for this target (lx) or
 * latitude (rad). */
double pp_en15193_supply(int class, double target_lx, double latitude_rad);

/* F_D,C of a class from 1 to 3, for automatic or manual control. */
double pp_en15193_control(int class, bool is_manual);

/* Calculates the saving for a box-shaped room with windows in one wall and without
 * overhangs or fins. For other rooms, standard->why is the reason why there is no
 * result. */
void pp_en15193_of_room(struct pp_lighting_standard *standard,
                        const struct pp_world *world, double latitude_rad,
                        const struct pp_lighting_control *control);

#endif
