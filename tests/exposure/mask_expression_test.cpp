#include "verdigris/exposure/mask_expression.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "verdigris/base/error.hpp"

using namespace verdigris;

namespace {

const std::vector<std::string> names{"wetness", "ao", "dust_2"};

float value(const char* text, float wetness = 0.25f, float ao = 0.5f) {
  const Field<float> a{wetness}, b{ao};
  const Field<float>* masks[] = {&a, &b, nullptr};
  return MaskExpression(text, names, "mask").evaluate(masks, 1)[0];
}

TEST(MaskExpression, KnowsItsOperatorsAndFunctions) {
  EXPECT_FLOAT_EQ(value("0.6 * wetness + 0.4 * (1 - ao)"), 0.35f);
  EXPECT_FLOAT_EQ(value("1 - 2 - 3"), -4.0f);
  EXPECT_FLOAT_EQ(value("2 ^ 3 ^ 2 / 4 * 2"), 256.0f);
  EXPECT_FLOAT_EQ(value("-2 ^ 2"), -4.0f);
  EXPECT_FLOAT_EQ(value("--2 * -(1)"), -2.0f);
  EXPECT_FLOAT_EQ(value("min(3, ao, wetness) + max(wetness, ao)"), 0.75f);
  EXPECT_FLOAT_EQ(value("clamp(5 * ao, 0, 1) + step(0.5, ao) + step(0.6, ao)"), 2.0f);
  EXPECT_FLOAT_EQ(value("smoothstep(0, 1, wetness)"), 0.25f * 0.25f * 2.5f);
  EXPECT_FLOAT_EQ(value("smoothstep(1, 0, wetness)"), 1.0f - 0.25f * 0.25f * 2.5f);
  EXPECT_FLOAT_EQ(value("mix(10, 20, ao)"), 15.0f);
  EXPECT_FLOAT_EQ(value("pow(ao, 2) + abs(-ao) + sqrt(wetness) + floor(1.7)"), 2.25f);
  EXPECT_NEAR(value("sin(pi / 2) + cos(pi) + exp(0) + log(exp(2))"), 3.0, 1e-6);
}

TEST(MaskExpression, HasNoHolesInIt) {
  EXPECT_EQ(value("1 / 0"), 0.0f);
  EXPECT_EQ(value("sqrt(-1)"), 0.0f);
}

TEST(MaskExpression, SaysWhichMasksItUses) {
  EXPECT_EQ(MaskExpression("ao * ao + wetness", names, "mask").used(), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_TRUE(MaskExpression("1 + 2", names, "mask").used().empty());
}

TEST(MaskExpression, SaysWhereItIsWrong) {
  const std::pair<const char*, int> bad[] = {{"", 1},
                                             {"1 +", 4},
                                             {"(ao", 4},
                                             {"ao wetness", 4},
                                             {"ao + rust", 6},
                                             {"min(ao)", 1},
                                             {"1 + clamp(1, 2)", 5},
                                             {"sqrt", 5},
                                             {"pow(1, 2", 9},
                                             {"2 ** 3", 4},
                                             {"1e99", 1},
                                             {"ao)", 3},
                                             {"ao $ 2", 4},
                                             {"foo(2)", 1},
                                             {"pow(1,,2)", 7}};
  for (const auto& [text, column] : bad) {
    try {
      MaskExpression(text, names, "masks.total.expression");
      ADD_FAILURE() << text;
    } catch (const InputError& e) {
      EXPECT_EQ(e.where(), "masks.total.expression, column " + std::to_string(column)) << text;
      EXPECT_FALSE(e.remedy().empty());
    }
  }
  EXPECT_THROW(MaskExpression(std::string(500, '('), names, "mask"), InputError);
  EXPECT_THROW(MaskExpression(std::string(5'000, '-') + "1" + std::string(500, '^'), names, "mask"),
               InputError);
}

TEST(MaskExpression, IsTheSameInLongFieldsAndForAnyNumberOfThreads) {
  const std::size_t slots = 100'003;
  Field<float> a(slots), b(slots);
  for (std::size_t k = 0; k < slots; ++k) {
    a[k] = static_cast<float>(k % 997) / 997.0f;
    b[k] = static_cast<float>(k % 31) / 31.0f;
  }
  const Field<float>* masks[] = {&a, &b, nullptr};
  const MaskExpression e("smoothstep(0.2, 0.8, wetness) * (1 - ao) + pow(ao, 1.7)", names, "mask");
  const Field<float> many = e.evaluate(masks, slots);
  for (const std::size_t k : {std::size_t{0}, std::size_t{511}, std::size_t{512}, slots - 1})
    EXPECT_EQ(many[k], value("smoothstep(0.2, 0.8, wetness) * (1 - ao) + pow(ao, 1.7)", a[k], b[k]));
  tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(e.evaluate(masks, slots), many);
}

}  // namespace
