/* test_gauss.c - Gauss-Legendre rules of all orders, compared with their definition. */
#include "model/geometry/gauss.h"

#include "tests/lib/near.h"

/* The integral of x^k from -1 to 1 is 2/(k + 1) for even k, otherwise 0. Every rule is
 * exact for k below twice its order, and too low for the next even k. Tolerance:
 * rounding of some hundred terms. */
static void powers_are_integrated_exactly_up_to_the_degree(void **state)
{
    (void)state;
    double nodes[PP_GAUSS_MOST], weights[PP_GAUSS_MOST];
    for (int order = 1; order <= PP_GAUSS_MOST; order++) {
        pp_gauss_legendre(nodes, weights, order);
        for (int k = 0; k <= 2 * order; k++) {
            double sum = 0.0, exact = k % 2 ? 0.0 : 2.0 / (k + 1.0);
            for (int i = 0; i < order; i++)
                sum += weights[i] * pow(nodes[i], k);
            if (k < 2 * order)
                assert_near(sum, exact, 1e-13);
            else if (order < 20) /* for higher orders the difference is only rounding */
                assert_true(sum < exact);
        }
    }
}

/* In ascending order, without duplicates and symmetrical; for order 3 the square root
 * of 3/5, with the weight 5/9. */
static void nodes_ascend_and_are_symmetrical(void **state)
{
    (void)state;
    double nodes[PP_GAUSS_MOST], weights[PP_GAUSS_MOST];
    for (int order = 1; order <= PP_GAUSS_MOST; order++) {
        pp_gauss_legendre(nodes, weights, order);
        for (int i = 0; i < order; i++) {
            assert_true(nodes[i] > (i ? nodes[i - 1] : -1.0) && nodes[i] < 1.0);
            assert_near(nodes[i], -nodes[order - 1 - i], 1e-14);
            assert_near(weights[i], weights[order - 1 - i], 1e-14);
        }
    }
    pp_gauss_legendre(nodes, weights, 3);
    assert_near(nodes[2], sqrt(0.6), 1e-15);
    assert_near(weights[2], 5.0 / 9.0, 1e-15);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(powers_are_integrated_exactly_up_to_the_degree),
        cmocka_unit_test(nodes_ascend_and_are_symmetrical),
    };
    add_tests(tests, NULL, NULL);
}
