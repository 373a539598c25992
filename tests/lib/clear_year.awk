# clear_year.awk - prints a weather file: a year at Brussels. From 9 to 16 h the direct normal
# irradiance is 400 W/m2 (or `direct`), the diffuse horizontal irradiance 150 W/m2 (or
# `diffuse`). All other hours are dark.
BEGIN {
    if (direct == "") direct = 400
    if (diffuse == "") diffuse = 150
    print "LOCATION,Brussels,-,BEL,made up,064510,50.90,4.53,1.0,58.0"
    print "HOLIDAYS/DAYLIGHT SAVINGS,No,3/26,10/28,0"
    print "DATA PERIODS,1,1,Data,Sunday,1/1,12/31"
    split("31 28 31 30 31 30 31 31 30 31 30 31", days, " ")
    for (m = 1; m <= 12; m++)
        for (d = 1; d <= days[m]; d++)
            for (h = 1; h <= 24; h++) {
                lit = h > 9 && h <= 16
                printf "%d,%d,%d,%d,0,?,10,7.5,84,101000,0,0,315,%d,%d,%d,0,0,0\n",
                    2001 + m % 2, m, d, h, lit ? 9999 : 0, lit * direct, lit * diffuse
            }
}
