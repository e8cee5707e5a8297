"""Python side of cosseratPicFoam: analytic solutions, cases, pictures."""
