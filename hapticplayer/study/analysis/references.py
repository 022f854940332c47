"""The works that a report refers to, as they are printed."""

CHRISTENSEN_2019 = (
    "Christensen R. H. B. (2019). ordinal: regression models for ordinal data. R package, "
    "version 2019.12-10."
)
CONOVER_1999 = (
    "Conover W. J. (1999). Practical Nonparametric Statistics, 3rd ed. Wiley."
)
EFRON_1993 = "Efron B., Tibshirani R. J. (1993). An Introduction to the Bootstrap. Chapman & Hall."
FRIEDMAN_1937 = (
    "Friedman M. (1937). The use of ranks to avoid the assumption of normality implicit "
    "in the analysis of variance. Journal of the American Statistical Association 32, "
    "675-701."
)
GREENHOUSE_1959 = (
    "Greenhouse S. W., Geisser S. (1959). On methods in the analysis of profile data. "
    "Psychometrika 24, 95-112."
)
HODGES_1963 = (
    "Hodges J. L., Lehmann E. L. (1963). Estimates of location based on rank tests. "
    "Annals of Mathematical Statistics 34, 598-611."
)
HOLM_1979 = (
    "Holm S. (1979). A simple sequentially rejective multiple test procedure. "
    "Scandinavian Journal of Statistics 6, 65-70."
)
KENDALL_1939 = (
    "Kendall M. G., Babington Smith B. (1939). The problem of m rankings. Annals of "
    "Mathematical Statistics 10, 275-287."
)
KERBY_2014 = (
    "Kerby D. S. (2014). The simple difference formula: an approach to teaching "
    "nonparametric correlation. Comprehensive Psychology 3, 11.IT.3.1."
)
LEHMANN_1975 = (
    "Lehmann E. L. (1975). Nonparametrics: Statistical Methods Based on Ranks. "
    "Holden-Day."
)
LIDDELL_2018 = (
    "Liddell T. M., Kruschke J. K. (2018). Analyzing ordinal data with metric models: what "
    "could possibly go wrong? Journal of Experimental Social Psychology 79, 328-348."
)
MANN_1947 = (
    "Mann H. B., Whitney D. R. (1947). On a test of whether one of two random variables "
    "is stochastically larger than the other. Annals of Mathematical Statistics 18, "
    "50-60."
)
MCCULLAGH_1980 = (
    "McCullagh P. (1980). Regression models for ordinal data. Journal of the Royal "
    "Statistical Society B 42, 109-142."
)
NEMENYI_1963 = (
    "Nemenyi P. B. (1963). Distribution-free multiple comparisons. PhD thesis, "
    "Princeton University."
)
NEWCOMBE_2006 = (
    "Newcombe R. G. (2006). Confidence intervals for an effect size measure based on the "
    "Mann-Whitney statistic. Part 2: asymptotic methods and evaluation. Statistics in "
    "Medicine 25, 559-573."
)
PHIPSON_2010 = (
    "Phipson B., Smyth G. K. (2010). Permutation P-values should never be zero. "
    "Statistical Applications in Genetics and Molecular Biology 9, 39."
)
SCHNEIDER_2003 = (
    "Schneider K. A., Bavelier D. (2003). Components of visual prior entry. Cognitive "
    "Psychology 47, 333-366."
)
SHAPIRO_1965 = (
    "Shapiro S. S., Wilk M. B. (1965). An analysis of variance test for normality "
    "(complete samples). Biometrika 52, 591-611."
)
STEVENS_1957 = (
    "Stevens S. S. (1957). On the psychophysical law. Psychological Review 64, 153-181."
)
LEVITT_1971 = (
    "Levitt H. (1971). Transformed up-down methods in psychoacoustics. Journal of the "
    "Acoustical Society of America 49, 467-477."
)
WETHERILL_1965 = (
    "Wetherill G. B., Levitt H. (1965). Sequential estimation of points on a psychometric "
    "function. British Journal of Mathematical and Statistical Psychology 18, 1-10."
)
WICHMANN_2001 = (
    "Wichmann F. A., Hill N. J. (2001). The psychometric function: I. Fitting, sampling, "
    "and goodness of fit. Perception & Psychophysics 63, 1293-1313."
)
WILCOXON_1945 = (
    "Wilcoxon F. (1945). Individual comparisons by ranking methods. Biometrics Bulletin "
    "1, 80-83."
)
WILSON_1927 = (
    "Wilson E. B. (1927). Probable inference, the law of succession, and statistical "
    "inference. Journal of the American Statistical Association 22, 209-212."
)
WOBBROCK_2011 = (
    "Wobbrock J. O., Findlater L., Gergle D., Higgins J. J. (2011). The aligned rank "
    "transform for nonparametric factorial analyses using only ANOVA procedures. "
    "Proceedings of CHI 2011, 143-146."
)
YARROW_2011 = (
    "Yarrow K., Jahn N., Durant S., Arnold D. H. (2011). Shifts of criteria or neural "
    "timing? The assumptions underlying timing perception studies. Consciousness and "
    "Cognition 20, 1518-1531."
)
