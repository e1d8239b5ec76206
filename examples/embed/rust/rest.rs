// bindgen export/include/strapdown.h --allowlist-function 'sd_.*' -o strapdown.rs
// OUT_DIR=. rustc rest.rs -L export/build -l static=strapdown_f32
#![allow(non_camel_case_types, non_snake_case, non_upper_case_globals, dead_code)]
mod strapdown {
    include!(concat!(env!("OUT_DIR"), "/strapdown.rs"));
}
use strapdown::*;

fn main() {
    let mut nav = sd_nav { lon_lat_height: [0.0, 0.8, 0.0], v_n: [0.0; 3], q_b2n_wxyz: [1.0, 0.0, 0.0, 0.0] };
    let up = [0.0, 0.0, 0.0981];
    let imu = sd_imu { dtheta_ib_b: [0.0; 3], dv_b: up, dtheta_before: [0.0; 3], dv_before: up, dt: 0.01 };
    for _ in 0..100 {
        let (mut place, mut v, mut q) = ([0.0; 3], [0.0; 3], [0.0; 4]);
        let status = unsafe { sd_step_f32(&nav, &imu, place.as_mut_ptr(), v.as_mut_ptr(), q.as_mut_ptr()) };
        assert_eq!(status, bs_status_BS_OK);
        nav = sd_nav { lon_lat_height: place, v_n: v, q_b2n_wxyz: q };
    }
    assert!(nav.v_n[2].abs() < 1.0);
    println!("at rest");
}
