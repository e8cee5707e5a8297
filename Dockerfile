# SPDX-License-Identifier: GPL-3.0-or-later
#
# cosseratPicFoam on Debian's OpenFOAM, built, as the user foam:
#     docker build -t cosseratpicfoam .
#     docker run -it cosseratpicfoam
FROM debian:12

RUN apt-get update \
 && apt-get install -y --no-install-recommends ca-certificates sudo \
 && rm -rf /var/lib/apt/lists/* \
 && useradd --create-home --shell /bin/bash foam \
 && echo 'foam ALL=(ALL) NOPASSWD: ALL' > /etc/sudoers.d/foam

COPY --chown=foam:foam . /home/foam/cosseratPicFoam
USER foam
WORKDIR /home/foam/cosseratPicFoam

RUN bin/setUp && ./Allwmake \
 && echo 'source ~/cosseratPicFoam/etc/bashrc' >> ~/.bashrc

CMD ["/bin/bash"]
